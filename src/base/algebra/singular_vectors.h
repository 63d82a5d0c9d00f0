#pragma once

#include <Eigen/Core>

namespace clevis {

/// A = U diag(σ) Vᵀ of a small dense matrix, with all singular vectors.
struct SingularVectors {
  Eigen::MatrixXd U;      ///< rows × rows, orthogonal
  Eigen::VectorXd sigma;  ///< falling, as many as the shorter side
  Eigen::MatrixXd V;      ///< columns × columns, orthogonal

  /// Singular values above an absolute bound, in units of A.
  Eigen::Index count_above(double bound) const {
    return (sigma.array() > bound).count();
  }
  /// Those above a share of the largest [1].
  Eigen::Index rank(double share) const {
    return sigma.size() == 0 ? 0 : count_above(share * sigma[0]);
  }
  /// Of a rank: what A leaves, N with A N = 0, orthonormal.
  auto left(Eigen::Index rank) const { return V.rightCols(V.cols() - rank); }
  /// Of a rank: what Aᵀ leaves, N with Nᵀ A = 0, orthonormal.
  auto left_rows(Eigen::Index rank) const {
    return U.rightCols(U.cols() - rank);
  }
};

/// By Jacobi rotations, so that small singular values are as exact as
/// large ones; divide and conquer from 16 columns on, exact to round-off of the
/// largest. A matrix without rows or columns has identities.
SingularVectors singular_vectors(const Eigen::MatrixXd& A);

/// Falling, as of singular_vectors().
Eigen::VectorXd singular_values(const Eigen::MatrixXd& A);

/// Orthonormal columns N with A N = 0.
/// @param share  of the largest singular value, up to which one counts as zero
///   [1].
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A, double share);

/// Orthonormal columns that span what those of A span.
/// @param share  as of null_space() [1].
Eigen::MatrixXd column_space(const Eigen::MatrixXd& A, double share);

}  // namespace clevis
