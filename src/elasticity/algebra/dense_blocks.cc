#include "elasticity/algebra/dense_blocks.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// Fortran entry points, as in dense_product.cc.
#define CLEVIS_BLAS(Real, potrf, trsm, syrk, gemm, trsv, gemv)                 \
  extern "C" {                                                                 \
  void potrf(const char* triangle, const int* n, Real* a, const int* lda,      \
             int* info);                                                       \
  void trsm(const char* side, const char* triangle, const char* transpose,     \
            const char* unit, const int* rows, const int* columns,             \
            const Real* alpha, const Real* a, const int* lda, Real* b,         \
            const int* ldb);                                                   \
  void syrk(const char* triangle, const char* transpose, const int* n,         \
            const int* inner, const Real* alpha, const Real* a,                \
            const int* lda, const Real* beta, Real* c, const int* ldc);        \
  void gemm(const char* transpose_a, const char* transpose_b, const int* rows, \
            const int* columns, const int* inner, const Real* alpha,           \
            const Real* a, const int* lda, const Real* b, const int* ldb,      \
            const Real* beta, Real* c, const int* ldc);                        \
  void trsv(const char* triangle, const char* transpose, const char* unit,     \
            const int* rows, const Real* a, const int* lda, Real* x,           \
            const int* stride);                                                \
  void gemv(const char* transpose, const int* rows, const int* columns,        \
            const Real* alpha, const Real* a, const int* lda, const Real* x,   \
            const int* stride_x, const Real* beta, Real* y,                    \
            const int* stride_y);                                              \
  }                                                                            \
  namespace clevis::elasticity {                                               \
  namespace {                                                                  \
  template <>                                                                  \
  struct Blas<Real> {                                                          \
    static constexpr auto* factor = potrf;                                     \
    static constexpr auto* solve = trsm;                                       \
    static constexpr auto* square = syrk;                                      \
    static constexpr auto* product = gemm;                                     \
    static constexpr auto* solve_vector = trsv;                                \
    static constexpr auto* product_vector = gemv;                              \
  };                                                                           \
  }                                                                            \
  }

namespace clevis::elasticity {
namespace {
template <typename Real>
struct Blas;
}
}  // namespace clevis::elasticity

CLEVIS_BLAS(double, dpotrf_, dtrsm_, dsyrk_, dgemm_, dtrsv_, dgemv_)
CLEVIS_BLAS(float, spotrf_, strsm_, ssyrk_, sgemm_, strsv_, sgemv_)
#undef CLEVIS_BLAS

namespace clevis::elasticity {
namespace {

template <typename Real>
constexpr Real kOne = 1;
template <typename Real>
constexpr Real kMinusOne = -1;
template <typename Real>
constexpr Real kZero = 0;
constexpr int kNext = 1;  // from one entry of a vector to the next

/// Consecutive rows or columns.
struct Range {
  int begin{}, end{};
  int size() const { return end - begin; }
};

std::vector<Range> cut(int begin, int end, int size) {
  std::vector<Range> ranges;
  for (int at = begin; at < end; at += size) {
    ranges.push_back({at, std::min(at + size, end)});
  }
  return ranges;
}

/// A matrix by columns, lower triangle.
template <typename Real>
struct Lower {
  Real* value;
  int stride;
  Real* at(int row, int column) const {
    return value + static_cast<std::ptrdiff_t>(column) * stride + row;
  }
};

/// C −= A Aᵀ for the block of C in these rows and columns, of which nothing
/// above the diagonal counts; row i of C and of A are counted alike.
template <typename Real>
void subtract_square(Lower<Real> c, Range rows, Range columns, const Real* a,
                     int stride, int inner) {
  const int n = columns.size();
  if (rows.begin == columns.begin) {
    Blas<Real>::square("L", "N", &n, &inner, &kMinusOne<Real>,
                       a + columns.begin, &stride, &kOne<Real>,
                       c.at(columns.begin, columns.begin), &c.stride);
    rows.begin = columns.end;
  }
  const int m = rows.size();
  if (m <= 0) return;
  Blas<Real>::product("N", "T", &m, &n, &inner, &kMinusOne<Real>,
                      a + rows.begin, &stride, a + columns.begin, &stride,
                      &kOne<Real>, c.at(rows.begin, columns.begin), &c.stride);
}

/// Blocks of a lower triangle of n rows in so many columns.
std::vector<std::pair<Range, Range>> blocks(int begin, int columns, int rows,
                                            int size) {
  std::vector<std::pair<Range, Range>> result;
  for (const Range& column : cut(begin, columns, size)) {
    for (const Range& row : cut(column.begin, rows, size)) {
      result.emplace_back(row, column);
    }
  }
  return result;
}

template <typename Real>
void subtract_square(Lower<Real> c, int begin, int columns, int rows,
                     const Real* a, int stride, int inner,
                     const ForTasks& run) {
  constexpr int kBlock = 512;
  const auto all = blocks(begin, columns, rows, kBlock);
  run(static_cast<int>(all.size()), [&](int i) {
    const auto& [row, column] = all[static_cast<std::size_t>(i)];
    subtract_square<Real>(c, row, column, a, stride, inner);
  });
}

/// Large panels, a block of columns after the other.
template <typename Real>
bool eliminate_blocks(MutablePanel<Real> panel, Real* border,
                      const ForTasks& run) {
  constexpr int kColumns = 256;
  constexpr int kRows = 512;
  const int rows = panel.rows();
  const Lower<Real> whole{panel.value, rows};
  for (const Range& own : cut(0, panel.own, kColumns)) {
    const int n = own.size();
    Real* diagonal = whole.at(own.begin, own.begin);
    int info = 0;
    Blas<Real>::factor("L", &n, diagonal, &rows, &info);
    if (info != 0) return false;
    const auto below = cut(own.end, rows, kRows);
    run(static_cast<int>(below.size()), [&](int i) {
      const Range& part = below[static_cast<std::size_t>(i)];
      const int m = part.size();
      Blas<Real>::solve("R", "L", "T", "N", &m, &n, &kOne<Real>, diagonal,
                        &rows, whole.at(part.begin, own.begin), &rows);
    });
    subtract_square<Real>(whole, own.end, panel.own, rows,
                          whole.at(0, own.begin), rows, n, run);
  }
  if (panel.later > 0) {
    subtract_square<Real>({border, panel.later}, 0, panel.later, panel.later,
                          panel.value + panel.own, rows, panel.own, run);
  }
  return true;
}

// One column, as of steps in time: the kernels for blocks would first copy the
// whole panel.
template <typename Real>
void forward_vector(Panel<Real> panel, Real* own, Real* border) {
  const int rows = panel.rows();
  Blas<Real>::solve_vector("L", "N", "N", &panel.own, panel.value, &rows, own,
                           &kNext);
  if (panel.later == 0) return;
  Blas<Real>::product_vector("N", &panel.later, &panel.own, &kOne<Real>,
                             panel.value + panel.own, &rows, own, &kNext,
                             &kZero<Real>, border, &kNext);
}

template <typename Real>
void backward_vector(Panel<Real> panel, const Real* border, Real* own) {
  const int rows = panel.rows();
  if (panel.later > 0) {
    Blas<Real>::product_vector("T", &panel.later, &panel.own, &kMinusOne<Real>,
                               panel.value + panel.own, &rows, border, &kNext,
                               &kOne<Real>, own, &kNext);
  }
  Blas<Real>::solve_vector("L", "T", "N", &panel.own, panel.value, &rows, own,
                           &kNext);
}

}  // namespace

void one_by_one(int tasks, const std::function<void(int)>& task) {
  for (int i = 0; i < tasks; ++i) task(i);
}

template <typename Real>
bool eliminate(MutablePanel<Real> panel, Real* border, const ForTasks& run) {
  constexpr int kLarge = 768;  // rows: the blocks of smaller ones are too few
  if (panel.own == 0) return true;
  const int rows = panel.rows();
  if (rows > kLarge) return eliminate_blocks<Real>(panel, border, run);
  int info = 0;
  Blas<Real>::factor("L", &panel.own, panel.value, &rows, &info);
  if (info != 0) return false;
  if (panel.later == 0) return true;
  Real* below = panel.value + panel.own;
  Blas<Real>::solve("R", "L", "T", "N", &panel.later, &panel.own, &kOne<Real>,
                    panel.value, &rows, below, &rows);
  Blas<Real>::square("L", "N", &panel.later, &panel.own, &kMinusOne<Real>,
                     below, &rows, &kOne<Real>, border, &panel.later);
  return true;
}

template <typename Real>
void forward(Panel<Real> panel, RowBlock<Real> own, MatrixOf<Real>& border) {
  const auto columns = static_cast<int>(own.cols());
  const auto stride = static_cast<int>(own.outerStride());
  const int rows = panel.rows();
  border.resize(panel.later, own.cols());
  if (panel.own == 0 || columns == 0) {
    border.setZero();
    return;
  }
  if (columns == 1) {
    forward_vector<Real>(panel, own.data(), border.data());
    return;
  }
  Blas<Real>::solve("L", "L", "N", "N", &panel.own, &columns, &kOne<Real>,
                    panel.value, &rows, own.data(), &stride);
  if (panel.later == 0) return;
  Blas<Real>::product("N", "N", &panel.later, &columns, &panel.own, &kOne<Real>,
                      panel.value + panel.own, &rows, own.data(), &stride,
                      &kZero<Real>, border.data(), &panel.later);
}

template <typename Real>
void backward(Panel<Real> panel, const MatrixOf<Real>& border,
              RowBlock<Real> own) {
  const auto columns = static_cast<int>(own.cols());
  const auto stride = static_cast<int>(own.outerStride());
  const int rows = panel.rows();
  if (panel.own == 0 || columns == 0) return;
  if (columns == 1) {
    backward_vector<Real>(panel, border.data(), own.data());
    return;
  }
  if (panel.later > 0) {
    Blas<Real>::product("T", "N", &panel.own, &columns, &panel.later,
                        &kMinusOne<Real>, panel.value + panel.own, &rows,
                        border.data(), &panel.later, &kOne<Real>, own.data(),
                        &stride);
  }
  Blas<Real>::solve("L", "L", "T", "N", &panel.own, &columns, &kOne<Real>,
                    panel.value, &rows, own.data(), &stride);
}

#define CLEVIS_INSTANTIATE(Real)                                             \
  template bool eliminate<Real>(MutablePanel<Real>, Real*, const ForTasks&); \
  template void forward<Real>(Panel<Real>, RowBlock<Real>, MatrixOf<Real>&); \
  template void backward<Real>(Panel<Real>, const MatrixOf<Real>&,           \
                               RowBlock<Real>);
CLEVIS_INSTANTIATE(double)
CLEVIS_INSTANTIATE(float)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
