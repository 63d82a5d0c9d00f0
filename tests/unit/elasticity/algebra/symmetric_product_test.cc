#include "elasticity/algebra/symmetric_product.h"

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <gtest/gtest.h>

namespace {

using namespace clevis;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr int kRows = 7;
constexpr double kRoundOff = 1e-13;  // of sums of 21 terms

/// The upper triangle of blocks of a random matrix, some of them left out, and
/// the whole matrix for comparison.
struct Sample {
  explicit Sample(int size) : blocks{.size = size, .rows = kRows} {
    whole = MatrixXd::Zero(size * kRows, size * kRows);
    row_start.push_back(0);
    for (int i = 0; i < kRows; ++i) {
      for (int j = i; j < kRows; ++j) {
        if ((i + 2 * j) % 3 == 1) continue;  // some diagonal ones too
        MatrixXd block = MatrixXd::Random(size, size);
        if (i == j) block = (block + block.transpose()).eval();
        whole.block(size * i, size * j, size, size) = block;
        whole.block(size * j, size * i, size, size) = block.transpose();
        column.push_back(j);
        entries.insert(entries.end(), block.data(), block.data() + size * size);
      }
      row_start.push_back(static_cast<int>(column.size()));
    }
    blocks.row_start = row_start.data();
    blocks.column = column.data();
    blocks.entries = entries.data();
  }

  elasticity::BlockRows blocks;
  std::vector<int> row_start, column;
  std::vector<double> entries;
  MatrixXd whole;
};

// How many shapes a part's vibration takes may hang on the last bit: where the
// shapes that its loads excite are few, round-off makes the next ones.
TEST(SymmetricProduct, OfNumbersHasTheBitsOfEigens) {
  const Sample sample(1);
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> sparse(
      kRows, kRows, static_cast<Index>(sample.entries.size()),
      sample.row_start.data(), sample.column.data(), sample.entries.data());
  for (const Index columns : {1, 2, 3, 8, 11}) {
    const MatrixXd x = MatrixXd::Random(kRows, columns);
    const MatrixXd wanted = sparse.selfadjointView<Eigen::Upper>() * x;
    EXPECT_EQ(elasticity::symmetric_product(sample.blocks, x), wanted);
  }
}

// A dense product of the whole matrix: of blocks of each size, and of columns
// that fill a group, leave some over, or are few.
TEST(SymmetricProduct, IsThatOfTheWholeMatrix) {
  for (int size = 1; size <= 3; ++size) {
    const Sample sample(size);
    for (const Index columns : {0, 1, 2, 3, 8, 9, 11, 19}) {
      const MatrixXd x = MatrixXd::Random(size * kRows, columns);
      const MatrixXd y = elasticity::symmetric_product(sample.blocks, x);
      ASSERT_EQ(y.cols(), columns);
      EXPECT_LE((y - sample.whole * x).norm(), kRoundOff * x.norm())
          << "blocks of " << size << ", " << columns << " columns";
    }
  }
}

// Columns that fill a group of eight have the bits that each has alone.
TEST(SymmetricProduct, DoesNotDependOnTheColumnsBeside) {
  const Sample sample(3);
  const MatrixXd x = MatrixXd::Random(3 * kRows, 10);
  const MatrixXd y = elasticity::symmetric_product(sample.blocks, x);
  for (Index k = 0; k < x.cols(); ++k) {
    EXPECT_EQ(elasticity::symmetric_product(sample.blocks, x.col(k)), y.col(k));
  }
}

}  // namespace
