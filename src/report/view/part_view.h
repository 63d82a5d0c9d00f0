#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "part/part_definition.h"
#include "report/view/packed_field.h"

namespace clevis::report {

/// An instant or case of a part: what it carries there.
struct ViewInstant {
  std::string label;       ///< "t = 1.25 s" or the case
  double time{};           ///< [s]
  double peak{};           ///< largest von Mises [Pa]
  double strain_energy{};  ///< [J]
};

/// A part as pictures show it: its surface with stress and displacement over
/// its instants. A place has one displacement, and a point for each stress
/// that cells have there.
struct PartView {
  part::PartDefinition definition;
  std::string body;                           ///< that carries it; empty: none
  Eigen::MatrixX3d positions;                 ///< of the places, in L [m]
  std::vector<int> places;                    ///< of the points, of `positions`
  std::vector<std::array<int, 3>> triangles;  ///< of points, outward
  std::vector<int>
      cell_triangles;  ///< how many of each cell, one after another
  /// Of a plate told by its mid-plane: edges of the outline,
  /// counterclockwise, and its two faces' z [m].
  std::vector<std::array<int, 2>> outline;
  std::optional<std::array<double, 2>> faces_z;
  std::vector<ViewInstant> frames;  ///< instants of the two fields
  bool is_motion{};  ///< they are instants of the motion, else cases
  int peak_point{};  ///< where the largest stress stands, of `places`
  int peak_frame{};
  PackedField stress;        ///< von Mises of the points [Pa]
  PackedField displacement;  ///< places × components, one after another [m]
  std::vector<ViewInstant> history;  ///< of all instants and cases
};

/// Error of `stress` and `displacement`, over the largest [1].
inline constexpr double kViewTolerance = 1e-3;
/// Version of the document: that of the others, but for the places (3).
inline constexpr int kPartViewSchema = 3;

/// One JSON document (docs/results.md, "The files of the report").
std::string part_view_json(const PartView& view);

}  // namespace clevis::report
