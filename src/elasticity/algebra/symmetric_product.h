#pragma once

#include <Eigen/Core>

namespace clevis::elasticity {

/// Upper triangle of a symmetric matrix in rows of dense blocks, compressed;
/// refers to numbers that others hold.
struct BlockRows {
  int size = 1;             ///< of a block, 1, 2 or 3
  int rows{};               ///< of blocks
  const int* row_start{};   ///< rows + 1
  const int* column{};      ///< of blocks; >= the row
  const double* entries{};  ///< size² a block, column after column
};

/// A X, a few columns at a time, which stay in the cache. The same bits for a
/// column whatever stands beside it, and on every processor; of numbers (blocks
/// of size 1) Eigen's.
Eigen::MatrixXd symmetric_product(const BlockRows& matrix,
                                  const Eigen::MatrixXd& x);

}  // namespace clevis::elasticity
