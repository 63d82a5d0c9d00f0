#include "base/algebra/singular_vectors.h"

#include <Eigen/SVD>

namespace clevis {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Eigen::Index rank_of(const VectorXd& sigma, double share) {
  return (sigma.array() > share * sigma[0]).count();
}

}  // namespace

SingularVectors singular_vectors(const MatrixXd& A) {
  if (A.size() == 0) {
    return {MatrixXd::Identity(A.rows(), A.rows()), VectorXd(0),
            MatrixXd::Identity(A.cols(), A.cols())};
  }
  const Eigen::BDCSVD<MatrixXd> svd(A,
                                    Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

VectorXd singular_values(const MatrixXd& A) {
  if (A.size() == 0) return VectorXd(0);
  return Eigen::BDCSVD<MatrixXd>(A).singularValues();
}

MatrixXd null_space(const MatrixXd& A, double share) {
  if (A.size() == 0) return MatrixXd::Identity(A.cols(), A.cols());
  const Eigen::BDCSVD<MatrixXd> svd(A, Eigen::ComputeFullV);
  return svd.matrixV().rightCols(A.cols() -
                                 rank_of(svd.singularValues(), share));
}

MatrixXd column_space(const MatrixXd& A, double share) {
  if (A.size() == 0) return MatrixXd(A.rows(), 0);
  const Eigen::BDCSVD<MatrixXd> svd(A, Eigen::ComputeThinU);
  return svd.matrixU().leftCols(rank_of(svd.singularValues(), share));
}

}  // namespace clevis
