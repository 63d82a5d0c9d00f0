#pragma once

#include <Eigen/Core>

namespace clevis {

/// Puts more columns behind those of a matrix that may have none yet.
/// @param more  no expression of `columns`.
template <typename Derived, typename Matrix>
void append_columns(const Eigen::MatrixBase<Derived>& more, Matrix& columns) {
  columns.conservativeResize(more.rows(), columns.cols() + more.cols());
  columns.rightCols(more.cols()) = more;
}

}  // namespace clevis
