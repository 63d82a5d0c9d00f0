#include "elasticity/plate/layered_solve.h"

#include <algorithm>
#include <cmath>

#include "base/values/stopwatch.h"
#include "elasticity/algebra/symmetric_product.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/direct/memory_forecast.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/plate/layered_equations.h"
#include "elasticity/plate/layered_stiffness.h"
#include "elasticity/plate/plate_layer.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/problem/refinement.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kCompressionTolerance = 3e-7;
/// Loads of a parity below this part of all are round-off of the other's.
constexpr double kNoLoad = 1e-8;

MatrixXd multiply(const UpperTriangle& upper, const MatrixXd& x) {
  return symmetric_product({1, upper.rows(), upper.row_start.data(),
                            upper.column.data(), upper.value.data()},
                           x);
}

StiffnessAction action_of(const UpperTriangle& upper) {
  return {[&upper](const MatrixXd& x) {
            return multiply(upper, x);
          },
          [&upper](const MatrixXd& x) {
            UpperTriangle absolute = upper;
            for (double& value : absolute.value) value = std::abs(value);
            return multiply(absolute, x);
          }};
}

void append(const MatrixXd& columns, const MatrixXd& coefficients,
            DisplacementBasis<3>& result) {
  MatrixXd all(columns.rows(), result.columns.cols() + columns.cols());
  all << result.columns, columns;
  MatrixXd c(result.coefficients.rows() + coefficients.rows(),
             coefficients.cols());
  c << result.coefficients, coefficients;
  result.columns = std::move(all);
  result.coefficients = std::move(c);
}

/// Solves for one parity and adds its columns.
void solve_parity(const Plate& plate, const Dissection& dissection,
                  const ThicknessReduction& reduction, const LoadBasis& basis,
                  DisplacementBasis<3>& result) {
  Stopwatch watch;
  const bool is_free = plate.fixed.empty();
  const auto equations = layered_equations(plate, reduction);
  const auto& [stiffness, held, numbers] = equations;
  result.seconds.assemble += watch.lap();
  const FrontalCholesky cholesky =
      factored(equations, dissection, reduction, "part " + plate.name);
  result.seconds.factor += watch.lap();
  MatrixXd terms = extend_rows(
      cholesky.solve(restrict_rows(basis.columns, numbers)), numbers);
  SolveChecks checks = result.checks;
  checks.compression = basis.compression_error;
  Eigen::VectorXd energy =
      check_solution(action_of(stiffness), terms, basis, held, is_free, checks);
  if (wants_refinement(checks)) {
    const StiffnessAction by_strain{
        [&](const MatrixXd& u) {
          return reduction.reduce(forces_by_strain(
              result.discretization, plate.material, reduction.expand(u)));
        },
        action_of(stiffness).multiply_absolute};
    refine(by_strain, inverse_by(cholesky), numbers, basis, terms);
    energy = check_solution(by_strain, terms, basis, held, is_free, checks);
  }
  result.strain_energy += energy;
  require_checks(checks, plate.plane.geometry_degree, plate.name);
  checks.equilibrium = std::max(checks.equilibrium, result.checks.equilibrium);
  checks.residual = std::max(checks.residual, result.checks.residual);
  checks.energy = std::max(checks.energy, result.checks.energy);
  checks.compression = std::max(checks.compression, result.checks.compression);
  result.checks = checks;
  append(reduction.expand(terms), basis.coefficients, result);
  result.seconds.solve += watch.lap();
}

}  // namespace

DisplacementBasis<3> solve_layered(const ElasticProblem<2>& problem, int degree,
                                   int terms) {
  Stopwatch watch;
  const std::string place = "part " + problem.name;
  const double density = problem.material.density;
  auto plane = discretize(problem.mesh, degree);
  const double dofs = 6.0 * terms * plane.nodes;
  require_dofs(dofs, problem.max_dofs, place);
  if (problem.tell_dofs) problem.tell_dofs(dofs);
  std::vector<int> place_of_node;
  const Dissection dissection = dissect_and_renumber(plane, place_of_node);
  DisplacementBasis<3> result;
  result.discretization = layer_over(plane, 2 * terms - 1);
  const auto& layer = result.discretization;
  const double unknowns = 3.0 * terms;
  require_memory(8.0 * dissection.entries * unknowns * unknowns,
                 unknowns * plane.nodes, usable_memory(), place);
  const auto positions = node_positions(layer);
  const bool is_free = problem.fixed.empty();
  SplitLoads history =
      load_columns(layer, problem.history, density, problem.name);
  if (is_free) {
    balance_free_part<3>(layer, positions, density, history, result.checks);
  }
  const auto integrals = plane_integrals(plane, place);
  result.columns.resize(layer.dofs(), 0);
  const Index instants = history.coefficients.cols();
  result.coefficients.resize(0, instants);
  result.strain_energy = Eigen::VectorXd::Zero(instants);
  result.seconds.assemble = watch.lap();

  const Plate plate{plane,         layer,       integrals, problem.material,
                    problem.fixed, problem.name};
  const double all = largest_instant(history);
  const MatrixXd columns = history.columns.whole();
  int parities = 0;
  for (const Parity parity : {Parity::kStretching, Parity::kBending}) {
    const ThicknessReduction reduction(parity, terms);
    watch.lap();
    LoadBasis loads =
        compress(split({reduction.reduce(columns), history.coefficients}),
                 kCompressionTolerance, all, problem.admitted_load_error);
    if (is_free) {
      restore_balance(
          reduction.rigid_modes(node_positions(plane), plane.thickness),
          loads.columns);
    }
    result.seconds.assemble += watch.lap();
    if (largest_instant(loads) <= kNoLoad * all) continue;
    solve_parity(plate, dissection, reduction, loads, result);
    ++parities;
  }
  result.is_mirrored = parities < 2;
  return result;
}

}  // namespace clevis::elasticity
