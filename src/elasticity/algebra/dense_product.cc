#include "elasticity/algebra/dense_product.h"

#include <cassert>
#include <type_traits>

// The Fortran entry point: the C one, cblas_dgemm, is also defined by GSL's
// plain reference library, which deal.II brings along and which wins.
extern "C" void dgemm_(const char* transpose_a, const char* transpose_b,
                       const int* rows, const int* columns, const int* inner,
                       const double* alpha, const double* a, const int* lda,
                       const double* b, const int* ldb, const double* beta,
                       double* c, const int* ldc);
extern "C" void sgemm_(const char* transpose_a, const char* transpose_b,
                       const int* rows, const int* columns, const int* inner,
                       const float* alpha, const float* a, const int* lda,
                       const float* b, const int* ldb, const float* beta,
                       float* c, const int* ldc);
extern "C" void dgemv_(const char* transpose, const int* rows,
                       const int* columns, const double* alpha, const double* a,
                       const int* lda, const double* x, const int* stride_x,
                       const double* beta, double* y, const int* stride_y);

namespace clevis::elasticity {
namespace {

constexpr auto gemm(double) {
  return dgemm_;
}
constexpr auto gemm(float) {
  return sgemm_;
}

template <typename Matrix>
Matrix multiply(char transpose, const Matrix& a, const Matrix& b) {
  using Real = typename Matrix::Scalar;
  const auto rows = static_cast<int>(transpose == 'T' ? a.cols() : a.rows());
  const auto inner = static_cast<int>(b.rows());
  const auto columns = static_cast<int>(b.cols());
  Matrix result(rows, columns);
  if (rows == 0 || columns == 0 || inner == 0) {
    result.setZero();
    return result;
  }
  const auto lda = static_cast<int>(a.rows());
  const Real one{1};
  const Real zero{0};
  const char plain = 'N';
  if constexpr (std::is_same_v<Real, double>) {
    if (columns == 1) {  // dgemm would copy all of A first
      const int next = 1;
      const auto a_columns = static_cast<int>(a.cols());
      dgemv_(&transpose, &lda, &a_columns, &one, a.data(), &lda, b.data(),
             &next, &zero, result.data(), &next);
      return result;
    }
  }
  gemm(Real{})(&transpose, &plain, &rows, &columns, &inner, &one, a.data(),
               &lda, b.data(), &inner, &zero, result.data(), &rows);
  return result;
}

}  // namespace

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  assert(a.cols() == b.rows());
  return multiply('N', a, b);
}

Eigen::MatrixXf product(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b) {
  assert(a.cols() == b.rows());
  return multiply('N', a, b);
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a,
                                   const Eigen::MatrixXd& b) {
  assert(a.rows() == b.rows());
  return multiply('T', a, b);
}

}  // namespace clevis::elasticity
