#include "elasticity/algebra/principal_columns.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

/// Columns that are neither orthogonal nor of one size.
MatrixXd skew_columns() {
  MatrixXd columns(9, 4);
  for (Eigen::Index k = 0; k < columns.size(); ++k) {
    columns.data()[k] = std::sin(static_cast<double>(2 + k * k));
  }
  return columns * Eigen::Vector4d(1.0, 1e8, 1e-8, 3.0).asDiagonal();
}

// Instants with the singular values 1, 0.1, 0.01 and 0.001 in the columns'
// norm: how many are kept and what is missing is known.
struct Known {
  Known() : columns(skew_columns()) {
    const Eigen::HouseholderQR<MatrixXd> qr(columns);
    const MatrixXd r =
        qr.matrixQR().topRows<4>().triangularView<Eigen::Upper>();
    MatrixXd instants = MatrixXd::Zero(4, 4);
    instants.diagonal() << 0.1, 0.001, 1.0, 0.01;
    coefficients = r.triangularView<Eigen::Upper>().solve(instants);
  }
  PrincipalColumns found(double admitted, Eigen::Index most = 4) const {
    return principal_columns(columns.transpose() * columns, coefficients,
                             admitted, most);
  }
  MatrixXd columns, coefficients;
};

TEST(PrincipalColumns, AreAsFewAsWhatMayBeMissingAllows) {
  const Known known;
  EXPECT_EQ(known.found(0.5).coefficients.rows(), 1);
  EXPECT_EQ(known.found(0.05).coefficients.rows(), 2);
  EXPECT_EQ(known.found(0.005).coefficients.rows(), 3);
  EXPECT_EQ(known.found(1e-6).coefficients.rows(), 4);
  EXPECT_EQ(known.found(1e-6, 2).coefficients.rows(), 2);
}

TEST(PrincipalColumns, MakeUpTheInstants) {
  const Known known;
  const MatrixXd wanted = known.columns * known.coefficients;
  for (const double missing : {0.1, 0.01, 0.001}) {
    const auto found = known.found(1.1 * missing);
    const MatrixXd rest =
        wanted - known.columns * found.combinations * found.coefficients;
    EXPECT_NEAR(rest.colwise().norm().maxCoeff() / missing, 1.0, 1e-6);
  }
}

TEST(PrincipalColumns, AreOrthonormalInTheNorm) {
  const Known known;
  const MatrixXd found = known.columns * known.found(1e-6).combinations;
  EXPECT_LT((found.transpose() * found - MatrixXd::Identity(4, 4))
                .cwiseAbs()
                .maxCoeff(),
            1e-6);
}

}  // namespace
}  // namespace clevis::elasticity
