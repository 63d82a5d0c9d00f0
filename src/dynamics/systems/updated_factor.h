#pragma once

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// B -> (A + weight C Cᵀ)⁻¹ B from A⁻¹ by [Woodbury1950], refined once where
/// what is added leaves little of a rigid motion that is large in A⁻¹.
/// @param solve    B -> A⁻¹ B. @param columns  C, size × few [√kg], [√(N/m)].
/// @param weight   of C Cᵀ [1/s²] or [1].
/// @param product  X -> (A + weight C Cᵀ) X.
BlockOperator updated_factor(const BlockOperator& solve,
                             const Eigen::MatrixXd& columns, double weight,
                             const BlockOperator& product);

}  // namespace clevis::dynamics
