#pragma once

#include <Eigen/Core>

#include "elasticity/nodal_loads/split_columns.h"

namespace clevis::elasticity {

/// A load history F (dofs × instants) as a few columns: F ≈ Q C.
struct LoadBasis {
  Eigen::MatrixXd columns;       ///< Q, near orthonormal, dofs × rank
  Eigen::MatrixXd coefficients;  ///< C, rank × instants
  /// max_i w_i ‖f_i − Q c_i‖ / max_i ‖f_i‖, w_i the tolerance over what is
  /// admitted of instant i [1].
  double compression_error{};
};

/// The same with more columns, which need not be independent, before they are
/// compressed.
struct SplitLoads {
  SplitColumns columns;
  Eigen::MatrixXd coefficients;
};

/// Puts columns that are zero but for a few rows first.
SplitLoads split(LoadBasis loads);

/// Truncated singular value decomposition of the history by Gram matrices of
/// the instants (few against the degrees of freedom), deflated in passes
/// because a Gram matrix squares the condition. Every column is a combination
/// of instants: if these are in balance, so is it.
/// @param tolerance  of compression_error.
LoadBasis compress(const Eigen::MatrixXd& history, double tolerance);

/// The same of loads that are columns times coefficients already.
/// @param scale  that `tolerance` and compression_error refer to; 0: the
///   largest instant.
/// @param admitted  of each instant, over `scale`: the tolerance or more [1];
///   empty: the tolerance.
LoadBasis compress(const SplitLoads& loads, double tolerance,
                   double scale = 0.0, const Eigen::VectorXd& admitted = {});

/// Norm of the largest instant, in the units of the loads.
double largest_instant(const SplitLoads& loads);
double largest_instant(const LoadBasis& loads);

}  // namespace clevis::elasticity
