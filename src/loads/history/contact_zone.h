#pragma once

#include <limits>
#include <string>

#include <Eigen/Core>

namespace clevis::loads {

/// A wall on which the counterpart of a slide travels: a flat one, two that
/// face each other, or a cylinder. Unit vectors, in L.
struct SlideWall {
  Eigen::Vector3d along_L = Eigen::Vector3d::UnitX();   ///< the slide
  Eigen::Vector3d across_L = Eigen::Vector3d::UnitY();  ///< in a flat wall
  Eigen::Vector3d normal_L = Eigen::Vector3d::UnitZ();  ///< of a flat wall
  std::string opposite;  ///< group of the second flat wall, or empty
};

/// Where the counterpart touches the wall at an instant: a rectangle along and
/// across the slide, measured from the seat's p_LS [m].
struct ContactZone {
  static constexpr double kAll = std::numeric_limits<double>::infinity();
  Eigen::Array2d low = Eigen::Array2d::Constant(-kAll);
  Eigen::Array2d high = Eigen::Array2d::Constant(kAll);
};

}  // namespace clevis::loads
