#pragma once

#include <vector>

#include "mechanism/joint_space/joint_coordinates.h"

namespace clevis::mechanism {

/// Sizes of the states of a tree of joints, by which errors are measured.
struct TreeScales {
  std::vector<double> q;  ///< by coordinate [m], [rad], of quaternions [1]
  std::vector<double> u;  ///< by velocity, over the speed per length [m], [rad]
};

/// Turns of a joint move what hangs on it: so far that it counts as a length.
/// @param coordinates  placed at x. @param length  of the links' order [m].
TreeScales tree_scales(const JointCoordinates& coordinates,
                       const Configuration& x, double length);

}  // namespace clevis::mechanism
