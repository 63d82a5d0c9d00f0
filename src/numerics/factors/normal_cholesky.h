#pragma once

#include <vector>

#include <Eigen/Core>

namespace clevis::numerics {

/// Cholesky of W Wᵀ for rows of W of length 1 that touch few 3-blocks of
/// columns each, within the skyline that this gives; and of the independent
/// rows alone where others depend on them. Rows of W are pure numbers.
class NormalCholesky {
 public:
  /// @param columns  a multiple of 3.
  NormalCholesky(int columns, int most_rows);

  /// Rows that follow are others than before.
  void reset(int rows);
  /// Row i of W: w, scaled to length 1. @return its length, or 1 for 0.
  double set_row(int i, const Eigen::VectorXd& w);
  auto row(int i) const { return Wt_.col(i); }
  /// wᵢ · v.
  double row_times(int i, const Eigen::VectorXd& v) const;
  /// v ← v + factor wᵢ.
  void add_row(int i, double factor, Eigen::VectorXd& v) const;

  /// In the order of the last pivoting. @param rank  rows that are taken to be
  /// independent, the first ones. @return whether they clearly are, and the
  /// others clearly depend on them.
  bool factor_in_order(int rank);
  /// Largest pivots first. @param rank  known from elsewhere, or −1.
  /// @return false if a pivot is neither safe nor, at that rank, zero.
  bool factor_by_pivots(int rank);

  /// x ← (W Wᵀ)⁻¹ of the rows that count, by row; 0 for the others.
  void solve(const Eigen::VectorXd& rows, Eigen::VectorXd& x);

  int rank() const { return rank_; }
  double smallest_pivot() const { return smallest_pivot_; }

 private:
  void order_by_rows();
  void place_skyline();
  double eliminate(int i, int rank);

  int rows_{}, rank_{};
  double smallest_pivot_ = 1.0;
  // pivots in the order of rows keep the skyline low, if they are safe
  bool may_sort_ = true, is_sorted_ = true, sort_next_ = false;
  std::vector<int> order_;
  std::vector<int> first_;     ///< of the skyline, by place in the order
  std::vector<int> first_at_;  ///< place that touches a block first
  std::vector<std::vector<int>> blocks_;  ///< that a row touches
  Eigen::MatrixXd Wt_;                    ///< columns: rows of W
  Eigen::MatrixXd L_;  ///< Lᵀ, with the inverse of its diagonal
  Eigen::VectorXd left_, x_;
};

}  // namespace clevis::numerics
