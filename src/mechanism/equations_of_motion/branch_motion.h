#pragma once

#include <optional>

#include <Eigen/Core>

#include "mechanism/equations_of_motion/equations_of_motion.h"

namespace clevis::mechanism {

/// Motion by forces at or beside a change point, where J leaves accelerations
/// open, on the branch of the velocities.
struct BranchMotion {
  Eigen::VectorXd accelerations;  ///< of the unknowns [m/s²]
  Eigen::MatrixXd open;  ///< columns: velocities that forces decide [1]
};

/// @param frame  that of the equations.
/// @param t, y  time [s] and state, whose velocities say which branch.
/// @param freedom  of the joints elsewhere [1].
/// @return nothing where no regular branch leads on.
/// Source: docs/theory.md, "Change points".
std::optional<BranchMotion> branch_motion(EquationsOfMotion& equations,
                                          const SolvingFrame& frame, double t,
                                          const Eigen::VectorXd& y,
                                          int freedom);

/// The same positions with quaternions, which planar motions do without.
Configuration with_quaternions(Configuration x);

}  // namespace clevis::mechanism
