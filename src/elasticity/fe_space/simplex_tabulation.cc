#include "elasticity/fe_space/simplex_tabulation.h"

#include <Eigen/Geometry>

#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/simplex_quadrature.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;

/// A rule on the line (dim = 1) or on the triangle.
template <int dim>
Quadrature<dim> rule_on_face(int n) {
  if constexpr (dim == 1) {
    const mesh::Quadrature rule = mesh::gauss(n);
    return {rule.points.transpose(), rule.weights};
  } else {
    return gauss_simplex<dim>(n);
  }
}

/// Area vector of the reference face with these corners, outward: its length
/// against the reference measure of the face's own coordinates is one.
Eigen::Vector2d normal(const Eigen::Matrix2d& corners) {
  const Eigen::Vector2d along = corners.col(1) - corners.col(0);
  return {along[1], -along[0]};
}
Eigen::Vector3d normal(const Eigen::Matrix3d& corners) {
  return (corners.col(1) - corners.col(0))
      .cross(corners.col(2) - corners.col(0));
}

}  // namespace

template <int dim>
Tabulation tabulate_simplex(int degree, const ReferencePoints<dim>& points) {
  auto table = mesh::simplex_lagrange<dim>(degree, points);
  return {std::move(table.value), {table.slope.begin(), table.slope.end()}};
}

template <int dim>
Quadrature<dim> gauss_simplex(int n) {
  auto rule = mesh::simplex_gauss<dim>(n);
  return {std::move(rule.points), std::move(rule.weights)};
}

template <int dim>
FaceQuadrature<dim> face_gauss_simplex(int face, int n) {
  const auto rule = rule_on_face<dim - 1>(n);
  Eigen::Matrix<double, dim, dim + 1> vertices;
  vertices.setZero();
  vertices.template rightCols<dim>().setIdentity();
  Eigen::Matrix<double, dim, dim> corners;
  for (int k = 0; k < dim; ++k) {
    corners.col(k) = vertices.col(
        mesh::simplex_face<dim>(face)[static_cast<std::size_t>(k)]);
  }
  FaceQuadrature<dim> result;
  result.weights = rule.weights;
  result.points = corners.col(0).replicate(1, rule.points.cols());
  for (int k = 1; k < dim; ++k) {
    result.points += (corners.col(k) - corners.col(0)) * rule.points.row(k - 1);
  }
  result.outward = normal(corners);
  const Eigen::Matrix<double, dim, 1> centre = vertices.rowwise().mean();
  if (result.outward.dot(corners.col(0) - centre) < 0.0) {
    result.outward *= -1.0;
  }
  return result;
}

template <int dim>
ReferencePoints<dim> lattice_simplex(int subdivisions) {
  const auto lattice = mesh::simplex_lattice<dim>(subdivisions);
  ReferencePoints<dim> points(dim, static_cast<Index>(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    for (std::size_t d = 0; d < dim; ++d) {
      points(static_cast<Index>(d), static_cast<Index>(i)) =
          static_cast<double>(lattice[i][d + 1]) / subdivisions;
    }
  }
  return points;
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template Tabulation tabulate_simplex<dim>(int, const ReferencePoints<dim>&); \
  template Quadrature<dim> gauss_simplex<dim>(int);                            \
  template FaceQuadrature<dim> face_gauss_simplex<dim>(int, int);              \
  template ReferencePoints<dim> lattice_simplex<dim>(int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
