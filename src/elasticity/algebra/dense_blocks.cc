#include "elasticity/algebra/dense_blocks.h"

// Fortran entry points, as in dense_product.cc.
extern "C" {
void dpotrf_(const char* triangle, const int* n, double* a, const int* lda,
             int* info);
void dtrsm_(const char* side, const char* triangle, const char* transpose,
            const char* unit, const int* rows, const int* columns,
            const double* alpha, const double* a, const int* lda, double* b,
            const int* ldb);
void dsyrk_(const char* triangle, const char* transpose, const int* n,
            const int* inner, const double* alpha, const double* a,
            const int* lda, const double* beta, double* c, const int* ldc);
void dgemm_(const char* transpose_a, const char* transpose_b, const int* rows,
            const int* columns, const int* inner, const double* alpha,
            const double* a, const int* lda, const double* b, const int* ldb,
            const double* beta, double* c, const int* ldc);
void dtrsv_(const char* triangle, const char* transpose, const char* unit,
            const int* rows, const double* a, const int* lda, double* x,
            const int* stride);
void dgemv_(const char* transpose, const int* rows, const int* columns,
            const double* alpha, const double* a, const int* lda,
            const double* x, const int* stride_x, const double* beta, double* y,
            const int* stride_y);
}

namespace clevis::elasticity {
namespace {

constexpr double kOne = 1.0, kMinusOne = -1.0, kZero = 0.0;
constexpr int kNext = 1;  // from one entry of a vector to the next

// One column, as of steps in time: the kernels for blocks would first copy the
// whole panel.
void forward_vector(Panel panel, double* own, double* border) {
  const int rows = panel.rows();
  dtrsv_("L", "N", "N", &panel.own, panel.value, &rows, own, &kNext);
  if (panel.later == 0) return;
  dgemv_("N", &panel.later, &panel.own, &kOne, panel.value + panel.own, &rows,
         own, &kNext, &kZero, border, &kNext);
}

void backward_vector(Panel panel, const double* border, double* own) {
  const int rows = panel.rows();
  if (panel.later > 0) {
    dgemv_("T", &panel.later, &panel.own, &kMinusOne, panel.value + panel.own,
           &rows, border, &kNext, &kOne, own, &kNext);
  }
  dtrsv_("L", "T", "N", &panel.own, panel.value, &rows, own, &kNext);
}

}  // namespace

bool eliminate(MutablePanel panel, double* border) {
  if (panel.own == 0) return true;
  const int rows = panel.rows();
  int info = 0;
  dpotrf_("L", &panel.own, panel.value, &rows, &info);
  if (info != 0) return false;
  if (panel.later == 0) return true;
  double* below = panel.value + panel.own;
  dtrsm_("R", "L", "T", "N", &panel.later, &panel.own, &kOne, panel.value,
         &rows, below, &rows);
  dsyrk_("L", "N", &panel.later, &panel.own, &kMinusOne, below, &rows, &kOne,
         border, &panel.later);
  return true;
}

void forward(Panel panel, RowBlock own, Eigen::MatrixXd& border) {
  const auto columns = static_cast<int>(own.cols());
  const auto stride = static_cast<int>(own.outerStride());
  const int rows = panel.rows();
  border.resize(panel.later, own.cols());
  if (panel.own == 0 || columns == 0) {
    border.setZero();
    return;
  }
  if (columns == 1) {
    forward_vector(panel, own.data(), border.data());
    return;
  }
  dtrsm_("L", "L", "N", "N", &panel.own, &columns, &kOne, panel.value, &rows,
         own.data(), &stride);
  if (panel.later == 0) return;
  dgemm_("N", "N", &panel.later, &columns, &panel.own, &kOne,
         panel.value + panel.own, &rows, own.data(), &stride, &kZero,
         border.data(), &panel.later);
}

void backward(Panel panel, const Eigen::MatrixXd& border, RowBlock own) {
  const auto columns = static_cast<int>(own.cols());
  const auto stride = static_cast<int>(own.outerStride());
  const int rows = panel.rows();
  if (panel.own == 0 || columns == 0) return;
  if (columns == 1) {
    backward_vector(panel, border.data(), own.data());
    return;
  }
  if (panel.later > 0) {
    dgemm_("T", "N", &panel.own, &columns, &panel.later, &kMinusOne,
           panel.value + panel.own, &rows, border.data(), &panel.later, &kOne,
           own.data(), &stride);
  }
  dtrsm_("L", "L", "T", "N", &panel.own, &columns, &kOne, panel.value, &rows,
         own.data(), &stride);
}

}  // namespace clevis::elasticity
