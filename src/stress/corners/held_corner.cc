#include "stress/corners/held_corner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace clevis::stress {
namespace {

using Eigen::Vector3d;
using Hold = WedgeSide::Hold;

constexpr double kPi = std::numbers::pi;
constexpr double kSkewRoller = 15.0;  // degrees

/// @param held  components of the group of that side.
HeldSide held_side(const BoundaryCorner& corner, const CornerSide& side,
                   const std::array<bool, 3>& held) {
  constexpr double kCounts = 0.5;  // of a unit component
  Eigen::Matrix3d components = Eigen::Matrix3d::Zero();
  for (int d = 0; d < 3; ++d) {
    if (held[static_cast<std::size_t>(d)]) {
      components.col(d) = Vector3d::Unit(d);
    }
  }
  const Vector3d across = corner.axis.cross(side.direction);
  Eigen::Matrix<double, 2, 3> in_plane;
  in_plane << side.direction.transpose() * components,
      across.transpose() * components;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 2, 3>> svd(in_plane,
                                                          Eigen::ComputeFullU);
  HeldSide result;
  result.along_axis = (corner.axis.transpose() * components).norm() > kCounts;
  if (svd.singularValues()[1] > kCounts) {
    result.wedge.hold = Hold::kBoth;
  } else if (svd.singularValues()[0] > kCounts) {
    result.wedge.hold = Hold::kOneDirection;
    const Eigen::Vector2d u = svd.matrixU().col(0);
    result.wedge.direction = std::atan2(u[1], u[0]);
  }
  return result;
}

bool is_roller(const WedgeSide& side) {
  return side.hold == Hold::kOneDirection &&
         std::abs(std::cos(side.direction)) < std::sin(kSkewRoller / 180 * kPi);
}

/// Angle of the material at the corner, of itself or with its mirror image
/// behind a roller; nothing where the sides are held unlike.
std::optional<double> whole_angle(double angle, const WedgeSide& first,
                                  const WedgeSide& second) {
  if (first.hold == second.hold) return angle;
  const bool mirrored = (is_roller(first) && second.hold == Hold::kNothing) ||
                        (is_roller(second) && first.hold == Hold::kNothing);
  if (mirrored) return 2.0 * angle;
  return std::nullopt;
}

}  // namespace

template <int dim>
std::vector<HeldCorner> held_corners(const mesh::PartMesh<dim>& mesh,
                                     const part::Supports& fixed) {
  std::vector<HeldCorner> result;
  for (const BoundaryCorner& corner : boundary_corners<dim>(mesh)) {
    HeldCorner& entry = result.emplace_back();
    entry.corner = corner;
    for (std::size_t s = 0; s < 2; ++s) {
      const int group = corner.sides[s].group;
      if (group < 0) continue;
      const auto found =
          fixed.find(mesh.groups[static_cast<std::size_t>(group)].name);
      if (found == fixed.end()) continue;
      auto components = found->second;
      if (dim == 2) components[2] = false;
      entry.held[s] = held_side(corner, corner.sides[s], components);
      if (std::ranges::count(components, true) > 0) {
        entry.name[s] = found->first;
      }
    }
    const auto angle =
        whole_angle(corner.angle, entry.held[0].wedge, entry.held[1].wedge);
    if (angle) entry.kink = *angle - kPi;
  }
  return result;
}

template std::vector<HeldCorner> held_corners<2>(const mesh::PartMesh<2>&,
                                                 const part::Supports&);
template std::vector<HeldCorner> held_corners<3>(const mesh::PartMesh<3>&,
                                                 const part::Supports&);

}  // namespace clevis::stress
