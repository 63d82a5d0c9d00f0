#include "elasticity/algebra/column_split.h"

#include <algorithm>

#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

std::vector<Index> all_up_to(Index count) {
  std::vector<Index> all(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<Index>(k);
  return all;
}

}  // namespace

ColumnSplit::ColumnSplit(const MatrixXd& columns) : columns_(&columns) {
  constexpr Index kSmallShare = 4;  // of the rows, for it to be worth while
  std::vector<bool> occurs(static_cast<std::size_t>(columns.rows()), false);
  for (Index k = 0; k < columns.cols(); ++k) {
    const auto column = columns.col(k).array();
    if (kSmallShare * (column != 0.0).count() > columns.rows()) {
      wide_.push_back(k);
      continue;
    }
    few_.push_back(k);
    for (Index row = 0; row < columns.rows(); ++row) {
      if (column[row] != 0.0) occurs[static_cast<std::size_t>(row)] = true;
    }
  }
  for (Index row = 0; row < columns.rows(); ++row) {
    if (occurs[static_cast<std::size_t>(row)]) rows_.push_back(row);
  }
  if (kSmallShare * static_cast<Index>(rows_.size()) > columns.rows()) {
    few_.clear();
    rows_.clear();
    wide_ = all_up_to(columns.cols());
  }
  if (few_.empty()) return;
  few_values_ = columns(rows_, few_);
  wide_values_ = columns(Eigen::all, wide_);
}

MatrixXd ColumnSplit::gram() const {
  if (few_.empty()) return transposed_product(*columns_, *columns_);
  MatrixXd result(columns_->cols(), columns_->cols());
  const MatrixXd mixed =
      transposed_product(few_values_, MatrixXd(wide()(rows_, Eigen::all)));
  result(few_, few_) = transposed_product(few_values_, few_values_);
  result(few_, wide_) = mixed;
  result(wide_, few_) = mixed.transpose();
  result(wide_, wide_) = transposed_product(wide(), wide());
  return result;
}

MatrixXd ColumnSplit::times(const MatrixXd& x) const {
  if (few_.empty()) return product(*columns_, x);
  MatrixXd result = product(wide(), MatrixXd(x(wide_, Eigen::all)));
  result(rows_, Eigen::all) +=
      product(few_values_, MatrixXd(x(few_, Eigen::all)));
  return result;
}

double ColumnSplit::largest_column_sum(const MatrixXd& x) const {
  constexpr Index kRows = 512;
  const MatrixXd of_few = product(few_values_, MatrixXd(x(few_, Eigen::all)));
  const MatrixXd of_wide = x(wide_, Eigen::all);
  Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(x.cols());
  auto row = rows_.begin();
  for (Index begin = 0; begin < columns_->rows(); begin += kRows) {
    const Index count = std::min(kRows, columns_->rows() - begin);
    MatrixXd here = product(MatrixXd(wide().middleRows(begin, count)), of_wide);
    for (; row != rows_.end() && *row < begin + count; ++row) {
      here.row(*row - begin) += of_few.row(row - rows_.begin());
    }
    sums += here.cwiseAbs().colwise().sum();
  }
  return sums.maxCoeff();
}

}  // namespace clevis::elasticity
