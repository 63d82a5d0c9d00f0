#pragma once

#include <optional>

#include "beam/theory/impact.h"
#include "mesh/cells/part_mesh.h"
#include "part/mass_properties.h"
#include "part/material.h"

namespace clevis::beam {

/// A part as the bar that beam theory takes it for.
struct BarOfPart {
  StruckBar bar;
  /// With the deflection h³/(E I) of [RotorLine]; of a rod the same.
  StruckBar published;
  double length{};      ///< from the held to the struck face [m]
  bool is_rod = false;  ///< struck along its axis, else a cantilever
};

/// A part that is held on one face and struck on another: from centroid to
/// centroid, with the section half way. None if it is no uniform bar (areas at
/// a tenth, half and nine tenths within 2 %), shorter than two of its depths,
/// or struck neither along nor across its axis.
/// @param root, tip  centroids of the faces in L [m].
/// @param direction  of the blow, unit, in L.
std::optional<BarOfPart> bar_of_part(const mesh::PartMesh<3>& mesh,
                                     const part::Material& material,
                                     double mass, const Eigen::Vector3d& root,
                                     const Eigen::Vector3d& tip,
                                     const Eigen::Vector3d& direction);

}  // namespace clevis::beam
