#include "mesh/basis/simplex_quadrature.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "mesh/basis/tensor_basis.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;

/// Rule of n points for ∫ f (1 − t)^power dt on [0, 1], from the eigenvalues
/// of the Jacobi matrix (Golub and Welsch, Math. Comp. 23, 1969).
Quadrature gauss_jacobi(int n, int power) {
  const double a = power;
  Eigen::VectorXd diagonal(n), beside(std::max(n - 1, 0));
  for (int k = 0; k < n; ++k) {
    const double twice = 2.0 * k + a;
    diagonal[k] = k == 0 ? -a / (a + 2.0) : -a * a / (twice * (twice + 2.0));
    if (k == 0) continue;
    beside[k - 1] =
        2.0 * k * (k + a) / (twice * std::sqrt((twice + 1.0) * (twice - 1.0)));
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
  eigen.computeFromTridiagonal(diagonal, beside);
  Quadrature rule;
  rule.points = 0.5 * (eigen.eigenvalues().array() + 1.0).matrix();
  rule.weights =
      eigen.eigenvectors().row(0).transpose().cwiseAbs2() / (a + 1.0);
  return rule;
}

}  // namespace

template <>
SimplexQuadrature<2> simplex_gauss<2>(int n) {
  const Quadrature outer = gauss_jacobi(n, 1), inner = gauss_jacobi(n, 0);
  SimplexQuadrature<2> rule{SimplexPoints<2>(2, n * n), Eigen::VectorXd(n * n)};
  Index q = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j, ++q) {
      const double u = outer.points[i];
      rule.points.col(q) << u, (1.0 - u) * inner.points[j];
      rule.weights[q] = outer.weights[i] * inner.weights[j];
    }
  }
  return rule;
}

template <>
SimplexQuadrature<3> simplex_gauss<3>(int n) {
  const Quadrature outer = gauss_jacobi(n, 2);
  const SimplexQuadrature<2> slice = simplex_gauss<2>(n);
  const Index m = slice.weights.size();
  SimplexQuadrature<3> rule{SimplexPoints<3>(3, n * m), Eigen::VectorXd(n * m)};
  for (int i = 0; i < n; ++i) {
    rule.points.row(0).segment(i * m, m).setConstant(outer.points[i]);
    rule.points.bottomRows<2>().middleCols(i * m, m) =
        (1.0 - outer.points[i]) * slice.points;
    rule.weights.segment(i * m, m) = outer.weights[i] * slice.weights;
  }
  return rule;
}

}  // namespace clevis::mesh
