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

}  // namespace clevis::elasticity
