#include "elasticity/algebra/symmetric_product.h"

#include <algorithm>
#include <cstddef>

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Four columns of a row side by side, wherever doubles may stand; the compiler
/// splits them where the processor has shorter registers.
using Four = double
    __attribute__((vector_size(32), aligned(alignof(double)), may_alias));

/// to += A from, each with `vectors` of `Lanes` a row, numbers in the order in
/// which Eigen adds them up. Inlined, so that each instruction set below has
/// its own.
template <int vectors, class Lanes>
[[gnu::always_inline]] inline void add_scalar_product(
    const BlockRows& matrix, const Lanes* __restrict from,
    Lanes* __restrict to) {
  for (int i = 0; i < matrix.rows; ++i) {
    const Lanes* own = from + static_cast<std::ptrdiff_t>(i) * vectors;
    Lanes* sum_at = to + static_cast<std::ptrdiff_t>(i) * vectors;
    Lanes sum[vectors];
    for (int v = 0; v < vectors; ++v) sum[v] = Lanes{};
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
      const int j = matrix.column[k];
      const double entry = matrix.entries[k];
      if (j == i) {
        for (int v = 0; v < vectors; ++v) sum_at[v] += entry * own[v];
        continue;
      }
      const Lanes* other = from + static_cast<std::ptrdiff_t>(j) * vectors;
      Lanes* mirrored = to + static_cast<std::ptrdiff_t>(j) * vectors;
      for (int v = 0; v < vectors; ++v) {
        sum[v] += entry * other[v];
        mirrored[v] += entry * own[v];
      }
    }
    for (int v = 0; v < vectors; ++v) sum_at[v] += sum[v];
  }
}

/// Likewise of blocks.
template <int size, int vectors, class Lanes>
[[gnu::always_inline]] inline void add_product(const BlockRows& matrix,
                                               const Lanes* __restrict from,
                                               Lanes* __restrict to) {
  constexpr int kRow = size * vectors;
  for (int i = 0; i < matrix.rows; ++i) {
    const Lanes* own = from + static_cast<std::ptrdiff_t>(i) * kRow;
    Lanes* sum_at = to + static_cast<std::ptrdiff_t>(i) * kRow;
    Lanes sum[size][vectors];
    for (int a = 0; a < size; ++a) {
      for (int v = 0; v < vectors; ++v) sum[a][v] = sum_at[a * vectors + v];
    }
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
      const int j = matrix.column[k];
      const double* block =
          matrix.entries + static_cast<std::ptrdiff_t>(k) * size * size;
      const Lanes* other = from + static_cast<std::ptrdiff_t>(j) * kRow;
      for (int b = 0; b < size; ++b) {
        for (int a = 0; a < size; ++a) {
          for (int v = 0; v < vectors; ++v) {
            sum[a][v] += block[size * b + a] * other[b * vectors + v];
          }
        }
      }
      if (j == i) continue;
      Lanes* mirrored = to + static_cast<std::ptrdiff_t>(j) * kRow;
      for (int b = 0; b < size; ++b) {
        for (int v = 0; v < vectors; ++v) {
          Lanes value = mirrored[b * vectors + v];
          for (int a = 0; a < size; ++a) {
            value += block[size * b + a] * own[a * vectors + v];
          }
          mirrored[b * vectors + v] = value;
        }
      }
    }
    for (int a = 0; a < size; ++a) {
      for (int v = 0; v < vectors; ++v) sum_at[a * vectors + v] = sum[a][v];
    }
  }
}

// No fused products: the same bits on every processor.
#if defined(__x86_64__)
#define CLEVIS_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLEVIS_CLONES
#endif

CLEVIS_CLONES void add_eight(const BlockRows& matrix, const double* x,
                             double* y) {
  const auto* from = reinterpret_cast<const Four*>(x);
  auto* to = reinterpret_cast<Four*>(y);
  if (matrix.size == 1) return add_scalar_product<2>(matrix, from, to);
  if (matrix.size == 2) return add_product<2, 2>(matrix, from, to);
  add_product<3, 2>(matrix, from, to);
}

void add_one(const BlockRows& matrix, const double* from, double* to) {
  if (matrix.size == 1) return add_scalar_product<1>(matrix, from, to);
  if (matrix.size == 2) return add_product<2, 1>(matrix, from, to);
  add_product<3, 1>(matrix, from, to);
}

}  // namespace

MatrixXd symmetric_product(const BlockRows& matrix, const MatrixXd& x) {
  constexpr Index kColumns = 8;
  constexpr Index kFew = 2;  // that cost less one by one
  using Rows = Eigen::Matrix<double, kColumns, Eigen::Dynamic>;
  MatrixXd result = MatrixXd::Zero(x.rows(), x.cols());
  Rows from = Rows::Zero(kColumns, x.rows());
  Rows to(kColumns, x.rows());
  Index first = 0;
  for (; x.cols() - first > kFew; first += kColumns) {
    const Index count = std::min(kColumns, x.cols() - first);
    from.topRows(count) = x.middleCols(first, count).transpose();
    to.setZero();
    add_eight(matrix, from.data(), to.data());
    result.middleCols(first, count) = to.topRows(count).transpose();
  }
  for (; first < x.cols(); ++first) {
    add_one(matrix, x.col(first).data(), result.col(first).data());
  }
  return result;
}

}  // namespace clevis::elasticity
