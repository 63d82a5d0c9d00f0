#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/driven_trajectory/driven_trajectory.h"

namespace clevis::mechanism {

/// Loads at a time [s] by the four looks about it [N], [N m]; nothing if there
/// are fewer.
std::optional<Eigen::VectorXd> by_cubic(
    const std::vector<DrivenTrajectory::At>& about, double t);

}  // namespace clevis::mechanism
