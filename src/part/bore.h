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

/// What there is of a cylinder's wall; n is its unit normal, either way.
struct Wall {
  double area{};                                          ///< [m²]
  Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();  ///< ∫ n dA [m²]
  Eigen::Matrix3d normal_square = Eigen::Matrix3d::Zero();  ///< ∫ n nᵀ dA [m²]

  Wall& operator+=(const Wall& other) {
    area += other.area;
    area_vector += other.area_vector;
    normal_square += other.normal_square;
    return *this;
  }
};

/// Whether a pin's pressure, which needs the wall all round, can go on a wall:
/// keyways, slots, cross bores and sloped ends take theirs. What is there may
/// be rings, or miss a little alike on all sides: of whole rings normals across
/// the axis are alike in all directions.
inline bool is_whole_wall(const Bore& bore, const Wall& wall) {
  const double full = wall_area(bore);
  if (std::abs(wall.area - full) <= kWholeWallTolerance * full) return true;
  const Eigen::Matrix3d even = 0.5 * (Eigen::Matrix3d::Identity() -
                                      bore.axis_L * bore.axis_L.transpose());
  const double tolerance = kWholeWallTolerance * wall.area;
  return wall.area < full &&
         (wall.normal_square - wall.area * even).norm() <= tolerance &&
         wall.area_vector.norm() <= tolerance;
}

}  // namespace clevis::part
