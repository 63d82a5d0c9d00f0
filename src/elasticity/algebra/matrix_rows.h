#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "elasticity/algebra/sparse_cholesky.h"

namespace clevis::elasticity {

/// Upper triangle of a symmetric matrix, row by row: whoever eliminates it row
/// by row needs no copy of all.
class MatrixRows {
 public:
  struct Row {
    std::span<const int> columns;  ///< sorted, from the diagonal on
    std::span<const double> values;
  };
  /// Room for a row that stands nowhere else.
  struct Room {
    std::vector<int> columns;
    std::vector<double> values;
  };
  using RowOf = std::function<Row(int row, Room& room)>;

  /// @param row_of  may be called by several threads, each with its own room.
  MatrixRows(int rows, RowOf row_of)
      : rows_(rows), row_of_(std::move(row_of)) {}

  /// @param matrix  outlives this.
  MatrixRows(const UpperTriangle& matrix)  // NOLINT: a matrix is its rows
      : MatrixRows(matrix.rows(), [&matrix](int row, Room&) {
          const auto i = static_cast<std::size_t>(row);
          const auto from = static_cast<std::size_t>(matrix.row_start[i]);
          const auto count =
              static_cast<std::size_t>(matrix.row_start[i + 1]) - from;
          return Row{std::span(matrix.column).subspan(from, count),
                     std::span(matrix.value).subspan(from, count)};
        }) {}

  int rows() const { return rows_; }
  /// The row stays as long as `room` and is not asked for again with it.
  Row row(int row, Room& room) const { return row_of_(row, room); }

 private:
  int rows_;
  RowOf row_of_;
};

}  // namespace clevis::elasticity
