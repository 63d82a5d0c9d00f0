#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

#include "numerics/factors/small_lu.h"

namespace clevis::numerics {

/// Singular values below this part of the largest count as zero. Not machine
/// epsilon: closer to a change point than that, rows that ought to be
/// dependent act as constraints with arbitrary multipliers.
inline constexpr double kRankThreshold = 3e-5;

/// Rank-revealing factorisation of a scaled constraint Jacobian J [1]: fast LU
/// where J is square and clearly regular, else a complete orthogonal
/// decomposition truncated at kRankThreshold.
class JacobianFactor {
 public:
  /// @param near  the factor of a matrix nearby, whose weakest() is a first
  ///   guess; or null.
  /// @param threshold  part of the largest singular value that counts as zero.
  void compute(const Eigen::MatrixXd& J, const JacobianFactor* near = nullptr,
               double threshold = kRankThreshold);
  /// By LU.
  bool is_regular() const { return regular_; }

  int rank() const { return rank_; }
  bool full_column_rank() const { return rank_ == columns_; }
  /// Sign of det J; 0 if J is not square or not regular.
  int determinant_sign() const { return determinant_sign_; }

  /// Singular vectors of the smallest singular value, J v = sigma u, about,
  /// and sigma from above; of full column rank only.
  struct Weakest {
    double sigma{};
    Eigen::VectorXd u, v;
  };
  Weakest weakest() const;

  /// Least-squares, minimal-norm solution of J x = b.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Minimal-norm, least-squares solution of Jᵀ λ = f.
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& f) const;

  /// Orthonormal columns N with Nᵀ J = 0: what equilibrium leaves open.
  Eigen::MatrixXd left_null_space() const;

 private:
  Weakest find_weakest(const JacobianFactor* near) const;

  bool regular_ = false;
  int rank_{}, rows_{}, columns_{}, determinant_sign_{};
  SmallLu lu_;
  Weakest weakest_;  ///< if regular
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> orthogonal_;
};

/// Rank and dependent rows of a Jacobian [1], by singular values.
struct RowDependence {
  int rank{};
  /// Rows that depend on others: their multipliers are not unique.
  std::vector<bool> dependent;
};
RowDependence row_dependence(const Eigen::MatrixXd& J);

/// Orthonormal columns N with J N = 0, by singular values.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& J);

/// Rank by singular values.
int numerical_rank(const Eigen::MatrixXd& J);

}  // namespace clevis::numerics
