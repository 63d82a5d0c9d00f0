#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

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

/// An edge of the part at which shear of a load ends and the stress is bounded,
/// but steep: it hangs on the direction, more than cells show.
struct SharpEnd {
  Eigen::Vector3d at;                  ///< its middle, in L [m]
  Eigen::Vector3d axis;                ///< unit
  double half{};                       ///< of its length [m]
  double reach{};                      ///< of the cells at it [m]
  std::array<unsigned, 2> vertices{};  ///< of the mesh, along the axis
  /// By how much the stress may differ at those: π/2 of what shear does not
  /// meet its like on the other face [Pa].
  std::array<double, 2> rise{};

  /// The same beside the edge, at a point within the cells at it; 0: beyond.
  double rise_beside(const Eigen::Vector3d& point) const;
};

/// Of all instants.
std::vector<SharpEnd> sharp_ends(const mesh::PartMesh<3>& mesh,
                                 const loads::SurfaceShear& shear);

/// The largest rise of those that a point is beside; 0: of none [Pa].
double rise_beside(const std::vector<SharpEnd>& ends,
                   const Eigen::Vector3d& point);

/// The largest stress that such shear alone may make where two edges meet, as
/// at the corners of a rectangle on which a torque is spread: 1.2 of the sum of
/// their rises [Pa].
double stress_at_corners(const std::vector<SharpEnd>& ends);

}  // namespace clevis::stress
