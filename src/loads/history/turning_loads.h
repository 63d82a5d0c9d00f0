#pragma once

#include <Eigen/Core>

namespace clevis::loads {

/// What loads of a part that turns on at one speed have in common in its frame,
/// where others that stand still in space turn: least squares of
/// c0 + c1 cos θ + c2 sin θ, c0 of each column.
/// @param angles  by instant [rad]. @param loads  instants × columns.
Eigen::VectorXd share_that_turns_with(const Eigen::VectorXd& angles,
                                      const Eigen::MatrixXd& loads);

}  // namespace clevis::loads
