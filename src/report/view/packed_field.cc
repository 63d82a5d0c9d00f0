#include "report/view/packed_field.h"

#include <algorithm>
#include <cmath>

namespace clevis::report {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Steps of a column's integers in one tolerance.
constexpr double kStepsOfFirst = 4.0, kSteps = 2.0;

/// A step of integers of which `largest` is a whole number.
double step_of(double largest, double wanted) {
  constexpr double kMost = 32767.0;
  return largest / std::clamp(std::ceil(largest / wanted), 1.0, kMost);
}

/// Instant that stands farthest from what the columns tell.
struct Worst {
  Index instant{};
  double error{};
};
Worst worst_of(const MatrixXd& rest) {
  Worst worst;
  for (Index i = 0; i < rest.cols(); ++i) {
    const double here = rest.col(i).lpNorm<Eigen::Infinity>();
    if (here > worst.error) worst = {i, here};
  }
  return worst;
}

}  // namespace

Eigen::MatrixXd PackedField::values() const {
  return integers.cast<double>() * scale.asDiagonal() *
         coefficients.cast<double>();
}

PackedField pack(Eigen::MatrixXd values, Eigen::Index first, double tolerance,
                 int most) {
  PackedField field;
  std::vector<VectorXd> columns;
  std::vector<double> scales;
  std::vector<Eigen::RowVectorXf> rows;
  Worst next{first, values.size() > 0
                        ? values.col(first).lpNorm<Eigen::Infinity>()
                        : 0.0};
  if (next.error == 0.0) next = worst_of(values);
  const Index told = next.instant;  // by the first column alone
  while (next.error > tolerance && static_cast<int>(columns.size()) < most) {
    const double scale = step_of(
        next.error, tolerance / (columns.empty() ? kStepsOfFirst : kSteps));
    // The rest is measured against the stored values, rounding and all.
    const VectorXd column = (values.col(next.instant) / scale).array().round();
    Eigen::RowVectorXf row =
        ((column.transpose() * values) / (scale * column.squaredNorm()))
            .cast<float>();
    if (columns.empty()) {
      row[told] = 1.0F;  // the column is that instant
    } else if (next.instant != told) {
      row[told] = 0.0F;
    }
    values.noalias() -= (scale * column) * row.cast<double>();
    columns.push_back(column);
    scales.push_back(scale);
    rows.push_back(row);
    next = worst_of(values);
  }
  field.error = next.error;
  const auto count = static_cast<Index>(columns.size());
  field.integers.resize(values.rows(), count);
  field.scale.resize(count);
  field.coefficients.resize(count, values.cols());
  for (Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    field.integers.col(k) = columns[at].cast<std::int16_t>();
    field.scale[k] = scales[at];
    field.coefficients.row(k) = rows[at];
  }
  return field;
}

}  // namespace clevis::report
