#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "elasticity/algebra/sparse_cholesky.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/dealii/dealii_solver.h"
#include "elasticity/fe_space/tabulation.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::support {

/// Traction [Pa] on a group as a function of place and outward unit normal.
template <int dim>
struct TractionField {
  using Vector = Eigen::Matrix<double, dim, 1>;
  std::string group;
  std::function<Vector(const Vector&, const Vector&)> traction;
};

/// Adds ∫ N t dA of a traction field to a nodal load.
template <int dim>
void add_traction(const elasticity::Discretization<dim>& discretization,
                  const TractionField<dim>& field, Eigen::MatrixXd& load) {
  const auto found = std::ranges::find(discretization.groups, field.group,
                                       &mesh::SurfaceGroup::name);
  const auto group =
      static_cast<std::size_t>(found - discretization.groups.begin());
  constexpr int points = 12;
  for (const auto& [cell, face] : discretization.group_faces[group]) {
    const auto rule =
        elasticity::face_gauss<dim>(discretization.shape, face, points);
    const auto values = elasticity::tabulate_displacement<dim>(
        discretization.shape, discretization.degree, rule.points);
    const auto c = static_cast<std::size_t>(cell);
    const auto at = elasticity::cell_geometry<dim>(
        discretization.cell_points[c],
        elasticity::CellInterpolation<dim>(
            discretization.shape, discretization.geometry_degree, rule.points));
    for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
      const Eigen::Matrix<double, dim, 1> area =
          at.determinant[q] *
          at.inverse_jacobian[static_cast<std::size_t>(q)].transpose() *
          rule.outward;
      const Eigen::Matrix<double, dim, 1> force =
          rule.weights[q] * area.norm() * discretization.thickness *
          field.traction(at.points.col(q), area.normalized());
      for (std::size_t i = 0; i < discretization.cell_nodes[c].size(); ++i) {
        load.col(0).template segment<dim>(dim *
                                          discretization.cell_nodes[c][i]) +=
            values.values(q, static_cast<Eigen::Index>(i)) * force;
      }
    }
  }
}

/// Force per volume [N/m³] as a function of place.
template <int dim>
using BodyField = std::function<Eigen::Matrix<double, dim, 1>(
    const Eigen::Matrix<double, dim, 1>&)>;

/// Adds ∫ N f dV of a body force to a nodal load.
template <int dim>
void add_body_force(const elasticity::Discretization<dim>& discretization,
                    const BodyField<dim>& field, Eigen::MatrixXd& load) {
  const int points = discretization.degree + 4;
  const auto rule = elasticity::gauss<dim>(discretization.shape, points);
  const auto displacement = elasticity::tabulate_displacement<dim>(
      discretization.shape, discretization.degree, rule.points);
  const elasticity::CellInterpolation<dim> geometry(
      discretization.shape, discretization.geometry_degree, rule.points);
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto at =
        elasticity::cell_geometry<dim>(discretization.cell_points[c], geometry);
    const auto& nodes = discretization.cell_nodes[c];
    for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
      const Eigen::Matrix<double, dim, 1> force =
          rule.weights[q] * at.determinant[q] * discretization.thickness *
          field(at.points.col(q));
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        load.col(0).template segment<dim>(dim * nodes[i]) +=
            displacement.values(q, static_cast<Eigen::Index>(i)) * force;
      }
    }
  }
}

/// K u = f with some components held at zero, by the library's own parts.
template <int dim>
Eigen::MatrixXd solve_held(const elasticity::StiffnessMatrix<dim>& stiffness,
                           const Eigen::MatrixXd& load,
                           const std::vector<int>& held) {
  std::vector<int> equation(static_cast<std::size_t>(load.rows()), 0);
  for (int dof : held) equation[static_cast<std::size_t>(dof)] = -1;
  int equations = 0;
  for (int& e : equation) e = e == 0 ? equations++ : -1;
  elasticity::UpperTriangle upper;
  upper.row_start.push_back(0);
  for (std::size_t dof = 0; dof < equation.size(); ++dof) {
    if (equation[dof] < 0) continue;
    const std::size_t node = dof / dim;
    for (int k = stiffness.row_start[node]; k < stiffness.row_start[node + 1];
         ++k) {
      const auto at = static_cast<std::size_t>(k);
      for (int b = 0; b < dim; ++b) {
        const int column =
            equation[static_cast<std::size_t>(dim * stiffness.column[at] + b)];
        if (column < equation[dof]) continue;
        upper.column.push_back(column);
        upper.value.push_back(
            stiffness.block[at](static_cast<int>(dof % dim), b));
      }
    }
    upper.row_start.push_back(static_cast<int>(upper.column.size()));
  }
  Eigen::MatrixXd right(equations, 1);
  for (std::size_t dof = 0; dof < equation.size(); ++dof) {
    if (equation[dof] >= 0) {
      right(equation[dof], 0) = load(static_cast<Eigen::Index>(dof), 0);
    }
  }
  const Eigen::MatrixXd free =
      elasticity::SparseCholesky(upper, "test").solve(right);
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(load.rows(), 1);
  for (std::size_t dof = 0; dof < equation.size(); ++dof) {
    if (equation[dof] >= 0) {
      u(static_cast<Eigen::Index>(dof), 0) = free(equation[dof], 0);
    }
  }
  return u;
}

/// Nodal load of tractions and a body force that the library's loads cannot
/// express, in addition to the first instant of the problem's history (may be
/// empty).
template <int dim>
Eigen::MatrixXd field_load(
    const elasticity::Discretization<dim>& discretization,
    const elasticity::ElasticProblem<dim>& problem,
    const std::vector<TractionField<dim>>& tractions,
    const BodyField<dim>& body) {
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(discretization.dofs(), 1);
  if (!problem.history.instants.empty()) {
    load = elasticity::assemble_loads(discretization, problem.history,
                                      problem.material.density, problem.name);
  }
  for (const auto& field : tractions) add_traction(discretization, field, load);
  if (body) add_body_force<dim>(discretization, body, load);
  return load;
}

/// One load case of field_load, by the problem's engine.
/// @param held  components held at zero instead of the problem's supports.
template <int dim>
elasticity::DisplacementBasis<dim> solve_field(
    const elasticity::ElasticProblem<dim>& problem,
    const std::vector<TractionField<dim>>& tractions, int degree,
    std::vector<int> held = {}, const BodyField<dim>& body = {}) {
  elasticity::DisplacementBasis<dim> basis;
  basis.discretization = elasticity::discretize(problem.mesh, degree);
  const auto& discretization = basis.discretization;
  const Eigen::MatrixXd load =
      field_load<dim>(discretization, problem, tractions, body);
  const auto positions = elasticity::node_positions(discretization);
  if (held.empty()) {
    held = problem.fixed.empty()
               ? elasticity::determinate_supports(discretization, positions)
               : elasticity::fixed_supports(discretization, positions,
                                            problem.fixed, problem.name);
  }
  if (problem.engine == elasticity::Engine::kDealii) {
    const elasticity::FoundationStiffness<dim> none(discretization, {}, "test");
    basis.columns = elasticity::DealiiSolver<dim>(
                        discretization, problem.material, none, held, "test")
                        .solve(load);
  } else {
    basis.columns =
        solve_held<dim>(elasticity::assemble_stiffness(
                            discretization, problem.material, "test"),
                        load, held);
  }
  basis.coefficients = Eigen::MatrixXd::Ones(1, 1);
  return basis;
}

}  // namespace clevis::support
