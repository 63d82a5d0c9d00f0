#pragma once

#include <optional>

#include <Eigen/Core>

#include "elasticity/problem/refinement.h"

namespace clevis::elasticity {

/// X with A X = B to the round-off of doubles by conjugate gradients, each
/// column by itself, with a factor in single precision as preconditioner: that
/// costs half of one in doubles.
/// @param multiply  X -> A X.
/// @param inverse   about A⁻¹, seven digits of its factor.
/// @return nothing where that does not converge.
std::optional<Eigen::MatrixXd> solve_by_single_precision(
    const StiffnessAction::Product& multiply, const Inverse& inverse,
    const Eigen::MatrixXd& right_hand_sides);

}  // namespace clevis::elasticity
