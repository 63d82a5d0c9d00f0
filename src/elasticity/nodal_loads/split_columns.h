#pragma once

#include <vector>

#include <Eigen/Core>

namespace clevis::elasticity {

/// Tall columns A. The first of them are zero but for a few rows, as loads of
/// surfaces are beside those of the body: memory and products have these rows
/// alone. Products have the units of A times those of X.
class SplitColumns {
 public:
  /// None.
  /// @param rows  of A.
  explicit SplitColumns(Eigen::Index rows);
  /// @param few_rows  rising.
  /// @param few   at these rows, rows × columns.
  /// @param wide  the columns behind them, of all rows.
  SplitColumns(std::vector<Eigen::Index> few_rows, Eigen::MatrixXd few,
               Eigen::MatrixXd wide);

  Eigen::Index rows() const { return wide_.rows(); }
  Eigen::Index cols() const { return few_.cols() + wide_.cols(); }

  Eigen::MatrixXd whole() const;  ///< A
  /// Consecutive rows of A.
  Eigen::MatrixXd middle_rows(Eigen::Index begin, Eigen::Index count) const;
  Eigen::MatrixXd gram() const;                           ///< Aᵀ A
  Eigen::MatrixXd times(const Eigen::MatrixXd& x) const;  ///< A X
  /// Xᵀ A.
  Eigen::MatrixXd transposed_times(const Eigen::MatrixXd& x) const;
  /// Sum of magnitudes of each column.
  Eigen::VectorXd magnitudes() const;
  /// Largest over the columns of A X of the sum of magnitudes, without forming
  /// A X at once.
  double largest_column_sum(const Eigen::MatrixXd& x) const;

  /// Puts columns of all rows behind these.
  void append(const Eigen::MatrixXd& wide);
  /// Leaves out the other columns. @param kept  rising.
  void keep(const std::vector<Eigen::Index>& kept);

 private:
  std::vector<Eigen::Index> few_rows_;
  Eigen::MatrixXd few_;   ///< at few_rows_
  Eigen::MatrixXd wide_;  ///< rows × columns
};

}  // namespace clevis::elasticity
