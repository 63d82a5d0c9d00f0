#pragma once

#include <vector>

#include <Eigen/Core>

namespace clevis {

/// Columns over their lengths, without those that are zero, whose direction is
/// not a number.
inline Eigen::MatrixXd unit_columns(const Eigen::MatrixXd& columns) {
  std::vector<Eigen::Index> counting;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    if (columns.col(k).squaredNorm() > 0.0) counting.push_back(k);
  }
  const Eigen::MatrixXd some = columns(Eigen::all, counting);
  return some.colwise().normalized();
}

}  // namespace clevis
