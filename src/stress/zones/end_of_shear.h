#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "loads/pressure/surface_shear.h"
#include "mesh/cells/part_mesh.h"
#include "stress/corners/held_corner.h"

namespace clevis::stress {

/// Where shear on a face ends and the stress has no bound.
struct EndOfShear {
  std::string group;  ///< of that face
  double rise{};      ///< see SingularZone [Pa]
};

/// Where shear ends on a smooth or re-entrant surface, or runs against a roller
/// at about a right angle, which mirrors it. The stress goes like the logarithm
/// of the distance, steepest along the shear; what is below a thousandth of a
/// zone's radius, a micrometre or so, is no longer elastic.
/// @return nothing where no shear ends or the stress stays bounded.
template <int dim>
std::optional<EndOfShear> end_of_shear(const mesh::PartMesh<dim>& mesh,
                                       const HeldCorner& at,
                                       const loads::SurfaceShear& shear);

/// By how much shear that ends at an edge of the part, where the stress is
/// bounded but steep, may change the stress at a point within the cells at that
/// edge: π/2 of what does not meet its like on the other face [Pa].
double rise_at_edges(const mesh::PartMesh<3>& mesh,
                     const loads::SurfaceShear& shear,
                     const Eigen::Vector3d& at);

}  // namespace clevis::stress
