#include "elasticity/plate/thickness_terms.h"

#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// dP_k/dζ of values as legendre_table gives: P'_k = P'_{k-2} + (2k-1) P_{k-1}.
MatrixXd legendre_slopes(const MatrixXd& values) {
  MatrixXd slopes = MatrixXd::Zero(values.rows(), values.cols());
  for (Index k = 1; k < values.rows(); ++k) {
    slopes.row(k) = static_cast<double>(2 * k - 1) * values.row(k - 1);
    if (k > 1) slopes.row(k) += slopes.row(k - 2);
  }
  return slopes;
}

MatrixXd select(const MatrixXd& table, int terms, Parity parity,
                int (*order)(Parity, int)) {
  MatrixXd rows(terms, table.cols());
  for (int a = 0; a < terms; ++a) rows.row(a) = table.row(order(parity, a));
  return rows;
}

}  // namespace

int in_plane_order(Parity parity, int term) {
  return 2 * term + (parity == Parity::kBending ? 1 : 0);
}

int transverse_order(Parity parity, int term) {
  return 2 * term + (parity == Parity::kStretching ? 1 : 0);
}

MatrixXd legendre_table(int highest, const VectorXd& points) {
  const Eigen::RowVectorXd x = 2.0 * points.transpose().array() - 1.0;
  MatrixXd values(highest + 1, x.size());
  values.row(0).setOnes();
  if (highest > 0) values.row(1) = x;
  for (Index k = 2; k <= highest; ++k) {
    values.row(k) =
        (static_cast<double>(2 * k - 1) * x.cwiseProduct(values.row(k - 1)) -
         static_cast<double>(k - 1) * values.row(k - 2)) /
        static_cast<double>(k);
  }
  return values;
}

ThicknessIntegrals thickness_integrals(Parity parity, int terms,
                                       double thickness) {
  const int highest = 2 * terms - 1;
  const auto rule = mesh::gauss(highest + 1);
  const MatrixXd values = legendre_table(highest, rule.points);
  const MatrixXd slopes = legendre_slopes(values) * (2.0 / thickness);
  const VectorXd weights = rule.weights * thickness;
  const MatrixXd u = select(values, terms, parity, in_plane_order);
  const MatrixXd du = select(slopes, terms, parity, in_plane_order);
  const MatrixXd w = select(values, terms, parity, transverse_order);
  const MatrixXd dw = select(slopes, terms, parity, transverse_order);
  const auto integral = [&](const MatrixXd& a, const MatrixXd& b) {
    MatrixXd product = a * weights.asDiagonal() * b.transpose();
    // Orthogonality makes structural zeros of what round-off leaves.
    const double scale = product.cwiseAbs().maxCoeff();
    return MatrixXd(
        (product.array().abs() < 1e-13 * scale).select(0.0, product));
  };
  return {integral(u, u),   integral(du, du), integral(w, w),
          integral(dw, dw), integral(u, dw),  integral(du, w)};
}

}  // namespace clevis::elasticity
