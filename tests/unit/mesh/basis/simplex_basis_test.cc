#include "mesh/basis/simplex_basis.h"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "mesh/basis/simplex_quadrature.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::mesh {
namespace {

double factorial(int n) {
  return std::tgamma(n + 1.0);
}

/// Some points inside the reference simplex.
template <int dim>
SimplexPoints<dim> inner_points() {
  return simplex_gauss<dim>(4).points;
}

TEST(SimplexBasis, QuadratureIsExactToItsDegreeAndNoFurther) {
  for (int n = 1; n <= 8; ++n) {
    const auto rule = simplex_gauss<3>(n);
    const auto flat = simplex_gauss<2>(n);
    EXPECT_GT(rule.weights.minCoeff(), 0.0);
    for (int a = 0; a <= 2 * n - 1; ++a) {
      for (int b = 0; a + b <= 2 * n - 1; ++b) {
        const double area = (flat.points.row(0).array().pow(a) *
                             flat.points.row(1).array().pow(b))
                                .matrix() *
                            flat.weights;
        const double want = factorial(a) * factorial(b) / factorial(a + b + 2);
        EXPECT_NEAR(area, want, 1e-14 * want) << n << ' ' << a << ' ' << b;
        const int c = 2 * n - 1 - a - b;
        const double volume = (rule.points.row(0).array().pow(a) *
                               rule.points.row(1).array().pow(b) *
                               rule.points.row(2).array().pow(c))
                                  .matrix() *
                              rule.weights;
        const double exact = factorial(a) * factorial(b) * factorial(c) /
                             factorial(a + b + c + 3);
        EXPECT_NEAR(volume, exact, 1e-13 * exact) << n << ' ' << a << ' ' << b;
      }
    }
    const double beyond =
        rule.points.row(0).array().pow(2 * n).matrix() * rule.weights;
    const double exact = factorial(2 * n) / factorial(2 * n + 3);
    EXPECT_GT(std::abs(beyond / exact - 1.0), 1e-9);
  }
}

/// Σ over a + b + c = degree of some polynomial and its gradient.
double polynomial(const Eigen::Vector3d& x, int degree) {
  return std::pow(0.3 + x[0] - 0.7 * x[1] + 0.4 * x[2], degree);
}

TEST(SimplexBasis, LagrangeReproducesPolynomialsAndTheirGradients) {
  const auto points = inner_points<3>();
  const Eigen::Vector3d direction(1.0, -0.7, 0.4);
  for (int degree = 1; degree <= 4; ++degree) {
    const auto nodes = simplex_nodes<3>(degree);
    Eigen::VectorXd at_nodes(nodes.cols());
    for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
      at_nodes[i] = polynomial(nodes.col(i), degree);
    }
    const auto table = simplex_lagrange<3>(degree, points);
    for (Eigen::Index q = 0; q < points.cols(); ++q) {
      EXPECT_NEAR(table.value.row(q).dot(at_nodes),
                  polynomial(points.col(q), degree), 1e-14);
      for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(table.slope[d].row(q).dot(at_nodes),
                    degree * polynomial(points.col(q), degree - 1) *
                        direction[Eigen::Index(d)],
                    1e-13);
      }
    }
    EXPECT_LT(table.value.cwiseAbs().rowwise().sum().maxCoeff(), 4.0)
        << "Lebesgue's constant of degree " << degree;
  }
}

TEST(SimplexBasis, NodesOfAFaceAreTheSameFromBothSides) {
  for (int degree = 1; degree <= 4; ++degree) {
    const auto nodes = simplex_nodes<3>(degree);
    const auto on_face = simplex_nodes<2>(degree);
    for (int face = 0; face < 4; ++face) {
      const auto& corner = simplex_face<3>(face);
      Eigen::Matrix<double, 3, 4> vertices;
      vertices << Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity();
      const auto lattice = simplex_face_lattice<3>(degree, face);
      ASSERT_EQ(Eigen::Index(lattice.size()), on_face.cols());
      for (std::size_t i = 0; i < lattice.size(); ++i) {
        const Eigen::Vector2d at = on_face.col(Eigen::Index(i));
        const Eigen::Vector3d want =
            (1.0 - at.sum()) * vertices.col(corner[0]) +
            at[0] * vertices.col(corner[1]) + at[1] * vertices.col(corner[2]);
        EXPECT_LT((nodes.col(lattice[i]) - want).norm(), 1e-15);
      }
    }
    // Every permutation of the vertices permutes the nodes.
    const auto lattice = simplex_lattice<3>(degree);
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      SimplexIndex<3> turned = {lattice[i][1], lattice[i][2], lattice[i][3],
                                lattice[i][0]};
      const auto at = std::find(lattice.begin(), lattice.end(), turned);
      const Eigen::Vector3d p = nodes.col(Eigen::Index(i));
      const Eigen::Vector3d want(p[1], p[2], 1.0 - p.sum());
      EXPECT_LT((nodes.col(at - lattice.begin()) - want).norm(), 1e-15);
    }
  }
}

template <int dim>
void expect_parts_fill(int n) {
  const auto lattice = simplex_lattice<dim>(n);
  double sum = 0.0;
  for (const auto& part : simplex_parts<dim>(n)) {
    Eigen::Matrix<double, dim, dim> edges;
    for (int k = 0; k < dim; ++k) {
      for (int d = 0; d < dim; ++d) {
        edges(d, k) =
            lattice[std::size_t(part[std::size_t(k) + 1])][std::size_t(d) + 1] -
            lattice[std::size_t(part[0])][std::size_t(d) + 1];
      }
    }
    EXPECT_NEAR(edges.determinant(), 1.0, 1e-14);
    sum += edges.determinant();
  }
  EXPECT_EQ(sum, std::pow(n, dim));
}

TEST(SimplexBasis, PartsFillTheSimplex) {
  for (int n = 1; n <= 5; ++n) {
    expect_parts_fill<2>(n);
    expect_parts_fill<3>(n);
  }
}

TEST(SimplexBasis, BernsteinCoefficientsBoundAPolynomial) {
  const auto points = inner_points<2>();
  const auto table = bernstein<2>(5, points);
  EXPECT_GE(table.value.minCoeff(), 0.0);
  EXPECT_LT((table.value.rowwise().sum().array() - 1.0).abs().maxCoeff(),
            1e-14);
  EXPECT_LT(table.slope[0].rowwise().sum().cwiseAbs().maxCoeff(), 1e-13);
}

}  // namespace
}  // namespace clevis::mesh
