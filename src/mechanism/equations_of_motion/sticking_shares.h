#pragma once

#include <Eigen/Core>

#include "mechanism/equations_of_motion/motion_constraints.h"

namespace clevis::mechanism {

/// Shares efforts among sticking lines whose rows depend on one another: of
/// the multipliers that give the same motion [N], scaled as the rows are, those
/// at which the sum of squares of efforts over their breakaways is least.
/// @pre constraints.factor() was of these rows.
void share_among_sticking(const MotionConstraints& constraints,
                          const ForceModel& forces, const ForceState& acting,
                          Eigen::VectorXd& multipliers);

}  // namespace clevis::mechanism
