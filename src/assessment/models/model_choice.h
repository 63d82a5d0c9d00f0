#pragma once

#include <optional>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// A part that is a plate along z with all loads and supports on its sides,
/// and the models of it that suit them.
struct PlateModel {
  mesh::PartMesh<2> mesh;         ///< the mid-plane
  mesh::PartMesh<2> quadrangles;  ///< the same, triangles cut into three
  bool suits_plane_stress{};      ///< loads and supports lie in the plane
  bool suits_layers{};            ///< terms through the thickness
};

/// Nothing if the part is no such plate or the job asks for 3-D.
/// @throws Error F005 if the job asks for a model that does not fit.
std::optional<PlateModel> plate_model(const PartJob& job);

}  // namespace clevis::assessment
