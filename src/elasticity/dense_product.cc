#include "elasticity/dense_product.h"

#include <cassert>

#include <cblas.h>

namespace clevis::elasticity {
namespace {

Eigen::MatrixXd multiply(CBLAS_TRANSPOSE transpose, const Eigen::MatrixXd& a,
                         const Eigen::MatrixXd& b) {
  const auto rows = static_cast<int>(transpose == CblasTrans ? a.cols()
                                                             : a.rows());
  const auto inner = static_cast<int>(b.rows());
  const auto columns = static_cast<int>(b.cols());
  Eigen::MatrixXd result(rows, columns);
  if (rows == 0 || columns == 0 || inner == 0) {
    result.setZero();
    return result;
  }
  cblas_dgemm(CblasColMajor, transpose, CblasNoTrans, rows, columns, inner, 1.0,
              a.data(), static_cast<int>(a.rows()), b.data(), inner, 0.0,
              result.data(), rows);
  return result;
}

}  // namespace

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  assert(a.cols() == b.rows());
  return multiply(CblasNoTrans, a, b);
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a,
                                   const Eigen::MatrixXd& b) {
  assert(a.rows() == b.rows());
  return multiply(CblasTrans, a, b);
}

}  // namespace clevis::elasticity
