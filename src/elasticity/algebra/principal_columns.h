#pragma once

#include <Eigen/Core>

namespace clevis::elasticity {

/// Combinations of columns, orthonormal in the norm of the columns' Gram
/// matrix, and what instants are made of by them.
struct PrincipalColumns {
  Eigen::MatrixXd combinations;  ///< columns × kept
  Eigen::MatrixXd coefficients;  ///< kept × instants
};

/// The fewest combinations of columns that make up what these are at instants.
/// @param gram  Gram matrix of the columns in the norm that counts.
/// @param coefficients  columns × instants.
/// @param admitted  norm that may be missing at an instant, over the largest
///   norm of one [1].
/// @param most  combinations, however much is missing then.
PrincipalColumns principal_columns(const Eigen::MatrixXd& gram,
                                   const Eigen::MatrixXd& coefficients,
                                   double admitted, Eigen::Index most);

/// Combinations of columns that span the same, orthonormal in the norm of the
/// columns' Gram matrix, columns × kept. Columns may differ by orders in
/// length.
/// @param dependent  squares of what is left out as dependent on others, over
///   the largest, of columns of one length [1].
Eigen::MatrixXd orthonormal_combinations(const Eigen::MatrixXd& gram,
                                         double dependent);

}  // namespace clevis::elasticity
