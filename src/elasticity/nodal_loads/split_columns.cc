#include "elasticity/nodal_loads/split_columns.h"

#include <algorithm>
#include <utility>

#include "base/algebra/append_columns.h"
#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;

SplitColumns::SplitColumns(Index rows) : few_(0, 0), wide_(rows, 0) {}

SplitColumns::SplitColumns(std::vector<Index> few_rows, MatrixXd few,
                           MatrixXd wide)
    : few_rows_(std::move(few_rows)),
      few_(std::move(few)),
      wide_(std::move(wide)) {}

MatrixXd SplitColumns::whole() const {
  MatrixXd result(rows(), cols());
  result.rightCols(wide_.cols()) = wide_;
  auto few = result.leftCols(few_.cols());
  few.setZero();
  few(few_rows_, Eigen::all) = few_;
  return result;
}

MatrixXd SplitColumns::middle_rows(Index begin, Index count) const {
  MatrixXd result = MatrixXd::Zero(count, cols());
  result.rightCols(wide_.cols()) = wide_.middleRows(begin, count);
  for (auto row = std::ranges::lower_bound(few_rows_, begin);
       row != few_rows_.end() && *row < begin + count; ++row) {
    result.row(*row - begin).head(few_.cols()) =
        few_.row(row - few_rows_.begin());
  }
  return result;
}

MatrixXd SplitColumns::gram() const {
  const Index few = few_.cols(), wide = wide_.cols();
  MatrixXd result(cols(), cols());
  result.topLeftCorner(few, few) = transposed_product(few_, few_);
  result.bottomRightCorner(wide, wide) = transposed_product(wide_, wide_);
  result.topRightCorner(few, wide) =
      transposed_product(few_, MatrixXd(wide_(few_rows_, Eigen::all)));
  result.bottomLeftCorner(wide, few) =
      result.topRightCorner(few, wide).transpose();
  return result;
}

MatrixXd SplitColumns::times(const MatrixXd& x) const {
  MatrixXd result = product(wide_, x.bottomRows(wide_.cols()));
  result(few_rows_, Eigen::all) += product(few_, x.topRows(few_.cols()));
  return result;
}

MatrixXd SplitColumns::transposed_times(const MatrixXd& x) const {
  MatrixXd result(x.cols(), cols());
  result.leftCols(few_.cols()) =
      transposed_product(MatrixXd(x(few_rows_, Eigen::all)), few_);
  result.rightCols(wide_.cols()) = transposed_product(x, wide_);
  return result;
}

Eigen::VectorXd SplitColumns::magnitudes() const {
  Eigen::VectorXd result(cols());
  result.head(few_.cols()) = few_.cwiseAbs().colwise().sum().transpose();
  result.tail(wide_.cols()) = wide_.cwiseAbs().colwise().sum().transpose();
  return result;
}

double SplitColumns::largest_column_sum(const MatrixXd& x) const {
  constexpr Index kRows = 512;
  const MatrixXd of_wide = x.bottomRows(wide_.cols());
  const MatrixXd of_few = product(few_, x.topRows(few_.cols()));
  Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(x.cols());
  auto row = few_rows_.begin();
  for (Index begin = 0; begin < rows(); begin += kRows) {
    const Index count = std::min(kRows, rows() - begin);
    MatrixXd here = product(MatrixXd(wide_.middleRows(begin, count)), of_wide);
    for (; row != few_rows_.end() && *row < begin + count; ++row) {
      here.row(*row - begin) += of_few.row(row - few_rows_.begin());
    }
    sums += here.cwiseAbs().colwise().sum();
  }
  return sums.maxCoeff();
}

void SplitColumns::append(const MatrixXd& wide) {
  append_columns(wide, wide_);
}

void SplitColumns::keep(const std::vector<Index>& kept) {
  std::vector<Index> few, wide;
  for (const Index k : kept) {
    if (k < few_.cols()) {
      few.push_back(k);
    } else {
      wide.push_back(k - few_.cols());
    }
  }
  if (std::ssize(few) < few_.cols()) few_ = few_(Eigen::all, few).eval();
  if (std::ssize(wide) < wide_.cols()) wide_ = wide_(Eigen::all, wide).eval();
}

}  // namespace clevis::elasticity
