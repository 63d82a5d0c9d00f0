#pragma once

#include <vector>

#include <Eigen/Core>

namespace clevis::numerics {

/// LU with row pivoting of a square matrix, column by column. Of the size of a
/// linkage's Jacobian (18, say) it takes a third of the time of Eigen's, which
/// is made for large blocks.
class SmallLu {
 public:
  void compute(const Eigen::MatrixXd& A);

  /// A x = b, Aᵀ x = f.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& f) const;

  double smallest_pivot() const { return smallest_; }
  double largest_pivot() const { return largest_; }
  /// 0 if a pivot is.
  int determinant_sign() const { return sign_; }

 private:
  Eigen::MatrixXd lu_;
  std::vector<Eigen::Index> rows_;  ///< of A, in the order of pivots
  double smallest_{}, largest_{};
  int sign_{};
};

}  // namespace clevis::numerics
