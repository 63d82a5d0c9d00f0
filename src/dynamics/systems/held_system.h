#pragma once

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// A free system with Cᵀ x = 0 besides, by multipliers: none of its equations
/// goes, its factors answer in the space that the constraints leave.
/// @param constraints  C, size × constraints.
LinearSystem held_system(const LinearSystem& free,
                         const Eigen::MatrixXd& constraints);

/// The columns and the rigid motions of `free` that make Cᵀ of them least.
Eigen::MatrixXd moved_to_constraints(const LinearSystem& free,
                                     const Eigen::MatrixXd& constraints,
                                     const Eigen::MatrixXd& columns);

}  // namespace clevis::dynamics
