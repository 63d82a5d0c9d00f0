#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"
#include "support/elastic_field_problem.h"
#include "support/ring_problems.h"

/// Quarters of elliptic plates of NAFEMS.
namespace clevis::support {

inline const part::Material kNafemsSteel{"", 210e9, 0.3, 7800.0, 355e6};

/// LE1: a membrane pulled outward by 10 MPa on its outer ellipse; sigma_yy at
/// D (2000, 0) mm is 92.7 MPa.
inline elasticity::DisplacementBasis<2> solve_le1(const mesh::PartMesh<2>& mesh,
                                                  int degree) {
  const TractionField<2> pull{
      "x1", [](const Eigen::Vector2d&, const Eigen::Vector2d& n) {
        return Eigen::Vector2d(10e6 * n);
      }};
  const loads::LoadHistory none;
  return solve_field<2>(
      {mesh,
       kNafemsSteel,
       none,
       {{"y0", {false, true, false}}, {"y1", {true, false, false}}},
       "LE1"},
      {pull}, degree);
}

/// LE10: 1 MPa on the upper face; the outer wall keeps x and y, and z on its
/// middle line, which no group of faces can say: held node by node. sigma_yy
/// at D (2, 0, 0.3) m is -5.38 MPa.
inline elasticity::DisplacementBasis<3> solve_le10(
    const mesh::PartMesh<3>& mesh, int degree) {
  const TractionField<3> pressure{
      "z1", [](const Eigen::Vector3d&, const Eigen::Vector3d& n) {
        return Eigen::Vector3d(-1e6 * n);
      }};
  const auto discretization = elasticity::discretize<3>(mesh, degree);
  const auto positions = elasticity::node_positions(discretization);
  std::vector<int> held;
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    const Eigen::Vector3d at = positions.col(i);
    const bool outer =
        Eigen::Vector2d(at.x() / 3.25, at.y() / 2.75).norm() > 1 - 1e-5;
    const int dof = 3 * static_cast<int>(i);
    if (outer || std::abs(at.x()) < 1e-9) held.push_back(dof);
    if (outer || std::abs(at.y()) < 1e-9) held.push_back(dof + 1);
    if (outer && std::abs(at.z()) < 1e-9) held.push_back(dof + 2);
  }
  const loads::LoadHistory none;
  return solve_field<3>({mesh, kNafemsSteel, none, {}, "LE10"}, {pressure},
                        degree, held);
}

/// A quarter between the two ellipses, its first line of cells along the inner
/// one, from D on.
template <int dim>
mesh::PartMesh<dim> elliptic_quarter(std::array<int, dim> divisions,
                                     mesh::CellShape shape) {
  using Vector = Eigen::Matrix<double, dim, 1>;
  constexpr int kDegree = 4;
  const auto map = [](const Vector& s) -> Vector {
    const double angle = std::numbers::pi / 2 * s[1];
    Vector p;
    p[0] = (2.0 + 1.25 * s[0]) * std::cos(angle);
    p[1] = (1.0 + 1.75 * s[0]) * std::sin(angle);
    if constexpr (dim == 3) p[2] = 0.6 * s[2] - 0.3;
    return p;
  };
  auto mesh = shape == mesh::CellShape::kSimplex
                  ? simplex_mesh<dim>(divisions, kDegree, map)
                  : structured_mesh<dim>(divisions, kDegree, map);
  if (dim == 2) mesh.thickness = 0.1;
  return mesh;
}

/// Mean of sigma_yy of the cells that meet at a point [Pa], which is a vertex.
template <int dim>
double stress_yy_at(const elasticity::DisplacementBasis<dim>& basis,
                    const Eigen::Matrix<double, dim, 1>& where) {
  const auto field = stress::instant_field<dim>(basis, kNafemsSteel, 1, 0);
  double sum = 0.0;
  int count = 0;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const Eigen::Matrix<double, dim, 1> at =
          field.points[c].row(q).template head<dim>();
      if ((at - where).norm() > 1e-6 * where.norm()) continue;
      sum += field.stress[c](q, 1);
      ++count;
    }
  }
  EXPECT_GT(count, 0);
  return sum / count;
}

}  // namespace clevis::support
