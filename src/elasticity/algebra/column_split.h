#pragma once

#include <vector>

#include <Eigen/Core>

namespace clevis::elasticity {

/// Tall columns most of which may be zero but for some rows, as loads of
/// surfaces are beside those of the body: products are taken over those rows.
/// Products have the units of A times those of X.
class ColumnSplit {
 public:
  /// @param columns  A; outlives this.
  explicit ColumnSplit(const Eigen::MatrixXd& columns);

  Eigen::MatrixXd gram() const;                           ///< Aᵀ A
  Eigen::MatrixXd times(const Eigen::MatrixXd& x) const;  ///< A X

  /// Largest over the columns of A X of the sum of magnitudes, without forming
  /// A X at once.
  double largest_column_sum(const Eigen::MatrixXd& x) const;

 private:
  const Eigen::MatrixXd& wide() const {
    return few_.empty() ? *columns_ : wide_values_;
  }

  const Eigen::MatrixXd* columns_;
  std::vector<Eigen::Index> few_;   ///< columns that only `rows_` have
  std::vector<Eigen::Index> wide_;  ///< the others
  std::vector<Eigen::Index> rows_;
  Eigen::MatrixXd few_values_;   ///< at rows_
  Eigen::MatrixXd wide_values_;  ///< unless all are wide
};

}  // namespace clevis::elasticity
