#pragma once

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// A system with masses of 1 beside it that nothing joins to it yet: behind its
/// equations so many more, u'' = f, which are rigid motions.
LinearSystem attached_system(const LinearSystem& system, Eigen::Index masses);

}  // namespace clevis::dynamics
