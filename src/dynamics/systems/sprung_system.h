#pragma once

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// A system on springs: K + S Sᵀ in place of K; its factors by [Woodbury1950]
/// from those of the system. Rigid motions that the springs hold vibrate.
/// @param springs  S, size × springs [√(N/m)].
LinearSystem sprung_system(const LinearSystem& system,
                           const Eigen::MatrixXd& springs);

}  // namespace clevis::dynamics
