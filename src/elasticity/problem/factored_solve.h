#pragma once

#include <string>

#include <Eigen/Core>

#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/problem/refinement.h"

namespace clevis::elasticity {

/// Of a factor.
enum class Precision { kDouble, kSingle };

/// A solution, and the factor that gave it.
struct FactoredSolution {
  Eigen::MatrixXd columns;
  Inverse inverse;  ///< keeps the factor
  double factor_seconds{}, solve_seconds{};
};

/// The one that takes less time: a factor in single precision costs half, and
/// conjugate gradients for each column (solve_by_single_precision).
/// @param flops    of the factor.
/// @param bytes    of the factor in doubles.
/// @param columns  to solve for.
Precision cheaper_precision(double flops, double bytes, double columns);

/// How a factor is made.
struct FactorOptions {
  Precision precision = Precision::kDouble;
  int threads = 1;
};

/// X with A X = B to the round-off of doubles. A factor in single precision
/// that fails is made anew in doubles.
/// @param multiply  X -> A X.
/// @param name  entity for messages ("part DCE").
/// @throws Error F002, F004.
FactoredSolution solve_by_factor(const MatrixRows& matrix,
                                 const FrontTree& tree,
                                 const StiffnessAction::Product& multiply,
                                 const Eigen::MatrixXd& right_hand_sides,
                                 const FactorOptions& options,
                                 const std::string& name);

}  // namespace clevis::elasticity
