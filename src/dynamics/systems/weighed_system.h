#pragma once

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// A system with masses attached: M + W Wᵀ in place of M; its factors by
/// [Woodbury1950] from those of the system.
/// @param weights  W, size × masses [√kg].
LinearSystem weighed_system(const LinearSystem& system,
                            const Eigen::MatrixXd& weights);

}  // namespace clevis::dynamics
