#pragma once

#include <optional>
#include <vector>

#include "assessment/job/part_job.h"
#include "mesh/derived/revolution.h"

namespace clevis::assessment {

/// A part that is a plate along z with all loads and supports on its sides.
struct PlateShape {
  mesh::PartMesh<2> mesh;         ///< the mid-plane
  mesh::PartMesh<2> quadrangles;  ///< the same, triangles cut into three
  bool is_loaded_in_plane{};      ///< and held in no other direction
  /// No pin or slide that matters lifts off within the thickness, nor does a
  /// slide's counterpart end there: pressures have no kink along it.
  bool is_pressed_through{};
};

/// A part as its models see it. Each shape is found when first asked for.
class PartShape {
 public:
  /// @param job  outlives the object.
  explicit PartShape(const PartJob& job) : job_(job) {}

  const PartJob& job() const { return job_; }
  /// Nothing if the part is none, rests on an elastic bed, or the job asks for
  /// 3-D.
  const std::optional<PlateShape>& plate() const;
  /// Nothing if the part is none whose loads and supports go all round.
  const std::optional<mesh::Revolution>& revolution() const;
  /// Of a plate: the instants that govern it, as governing_loads() finds them.
  /// @pre plate().
  const std::vector<LoadSet>& governing() const;

 private:
  const PartJob& job_;
  mutable std::optional<std::optional<PlateShape>> plate_;
  mutable std::optional<std::optional<mesh::Revolution>> revolution_;
  mutable std::optional<std::vector<LoadSet>> governing_;
};

/// Whether a face rests on a foundation.
bool has_bed(const PartJob& job);

/// Whether supports or foundations hold the part in a case.
bool is_held(const PartJob& job);

/// Whether supports hold a part across its plane.
bool is_held_across(const PartJob& job);

/// Whether in a case nothing but the plane keeps the part in its plane: its
/// supports hold x or y only.
bool leaves_plane_free(const PartJob& job);

}  // namespace clevis::assessment
