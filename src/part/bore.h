#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace clevis::part {

/// A circular cylindrical surface of a link: a bore that a pin fills, or the
/// outside of a piston. Frame L.
struct Bore {
  Eigen::Vector3d p_LC;    ///< middle of the axis [m]
  Eigen::Vector3d axis_L;  ///< unit vector
  double radius{};         ///< [m]
  double length{};         ///< along the axis [m]
};

/// Part of a whole cylinder's area that a wall's may differ by [1]. A mesh
/// with exact geometry has it to 1e-6; a bore that is open on one side misses
/// far more.
inline constexpr double kWholeWallTolerance = 0.02;

/// Of a wall that is whole all round, over its length [m²].
inline double wall_area(const Bore& bore) {
  return 2.0 * std::numbers::pi * bore.radius * bore.length;
}

/// Whether a pin's pressure, which needs the wall all round, can go on a wall
/// of this area [m²]: keyways, slots, cross bores and sloped ends take theirs.
inline bool is_whole_wall(const Bore& bore, double area) {
  const double full = wall_area(bore);
  return std::abs(area - full) <= kWholeWallTolerance * full;
}

}  // namespace clevis::part
