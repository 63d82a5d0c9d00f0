#include "elasticity/displacement_basis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/errors.h"
#include "base/stopwatch.h"
#include "elasticity/dense_product.h"
#include "elasticity/load_basis.h"
#include "elasticity/load_vectors.h"
#include "elasticity/memory_forecast.h"
#include "elasticity/sparse_cholesky.h"
#include "elasticity/stiffness.h"
#include "elasticity/supports.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kCompressionTolerance = 3e-7;

// Bounds of the self-checks: far above round-off, far below any use.
constexpr double kReliefFaceted = 5e-2;  // geometry of degree 1
constexpr double kRelief = 1e-3;         // of higher degree, on coarse cells
constexpr double kBalance = 1e-12;
constexpr double kEquilibrium = 1e-9;
constexpr double kResidual = 1e-8;
constexpr double kResidualRoundOff = 1e-12;  // of ‖|K| |u|‖
constexpr double kEnergy = 1e-8;
constexpr double kCompression = 1e-6;

/// Equation number of every degree of freedom; -1 if it is held.
std::vector<int> number_equations(int dofs, const std::vector<int>& held) {
  std::vector<int> equation(static_cast<std::size_t>(dofs), 0);
  for (int dof : held) equation[static_cast<std::size_t>(dof)] = -1;
  int next = 0;
  for (int& e : equation) {
    if (e == 0) e = next++;
  }
  return equation;
}

template <int dim>
UpperTriangle free_equations(const StiffnessMatrix<dim>& stiffness,
                             const std::vector<int>& equation) {
  UpperTriangle upper;
  upper.row_start.push_back(0);
  upper.column.reserve(stiffness.column.size() * dim * dim);
  upper.value.reserve(stiffness.column.size() * dim * dim);
  for (int node = 0; node < stiffness.nodes(); ++node) {
    const auto n = static_cast<std::size_t>(node);
    for (int a = 0; a < dim; ++a) {
      const int row = equation[dim * n + static_cast<std::size_t>(a)];
      if (row < 0) continue;
      for (int k = stiffness.row_start[n]; k < stiffness.row_start[n + 1];
           ++k) {
        const auto at = static_cast<std::size_t>(k);
        const auto other = static_cast<std::size_t>(stiffness.column[at]);
        for (int b = 0; b < dim; ++b) {
          const int column =
              equation[dim * other + static_cast<std::size_t>(b)];
          if (column < row) continue;  // held, or below the diagonal
          upper.column.push_back(column);
          upper.value.push_back(stiffness.block[at](a, b));
        }
      }
      upper.row_start.push_back(static_cast<int>(upper.column.size()));
    }
  }
  return upper;
}

MatrixXd restrict_rows(const MatrixXd& full, const std::vector<int>& equation,
                       int rows) {
  MatrixXd result(rows, full.cols());
  for (std::size_t dof = 0; dof < equation.size(); ++dof) {
    if (equation[dof] >= 0) {
      result.row(equation[dof]) = full.row(static_cast<Index>(dof));
    }
  }
  return result;
}

MatrixXd extend_rows(const MatrixXd& reduced,
                     const std::vector<int>& equation) {
  MatrixXd result =
      MatrixXd::Zero(static_cast<Index>(equation.size()), reduced.cols());
  for (std::size_t dof = 0; dof < equation.size(); ++dof) {
    if (equation[dof] >= 0) {
      result.row(static_cast<Index>(dof)) = reduced.row(equation[dof]);
    }
  }
  return result;
}

/// Puts the discrete loads of a free part in balance and checks it.
template <int dim>
void balance(const Discretization<dim>& discretization,
             const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions,
             double density, MatrixXd& history, SolveChecks& checks) {
  const double length =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  const MatrixXd modes =
      rigid_modes<dim>(positions, positions.rowwise().mean(), length);
  checks.relief = balance_loads(discretization, density, modes, history);
  const double scale = history.cwiseAbs().colwise().sum().maxCoeff();
  if (!(scale > 0.0)) return;
  checks.balance =
      transposed_product(modes, history).cwiseAbs().maxCoeff() / scale;
}

template <int dim>
void check_solution(const StiffnessMatrix<dim>& stiffness,
                    const std::vector<int>& equation, const LoadBasis& basis,
                    bool is_free, DisplacementBasis<dim>& result) {
  result.strain_energy = Eigen::VectorXd::Zero(basis.coefficients.cols());
  if (basis.columns.cols() == 0) return;  // nothing loads the part
  SolveChecks& checks = result.checks;
  const MatrixXd forces = stiffness.multiply(result.columns);
  MatrixXd rest = forces - basis.columns;
  MatrixXd reactions(0, rest.cols());
  for (std::size_t dof = 0; dof < equation.size(); ++dof) {
    if (equation[dof] >= 0) continue;
    const auto row = static_cast<Index>(dof);
    reactions.conservativeResize(reactions.rows() + 1, Eigen::NoChange);
    reactions.bottomRows<1>() = rest.row(row);
    rest.row(row).setZero();
  }
  const Eigen::ArrayXd load_norm =
      basis.columns.colwise().norm().transpose().array();
  checks.residual =
      (rest.colwise().norm().transpose().array() / load_norm).maxCoeff();
  if (checks.residual > kResidual) {
    // K u of a slender part is a small difference of large terms.
    const Eigen::ArrayXd terms = stiffness.absolute()
                                     .multiply(result.columns.cwiseAbs())
                                     .colwise()
                                     .norm()
                                     .transpose()
                                     .array();
    checks.residual_round_off =
        kResidualRoundOff * (terms / load_norm).maxCoeff();
  }
  if (is_free) {
    // Per instant: a column of small weight may carry round-off of large ones.
    const double load =
        product(basis.columns, result.coefficients).colwise().norm().maxCoeff();
    checks.equilibrium =
        (reactions * result.coefficients).colwise().norm().maxCoeff() / load;
  }
  // Energies per instant, once with K and once with the loads.
  const MatrixXd by_stiffness = transposed_product(result.columns, forces);
  const MatrixXd by_loads = transposed_product(result.columns, basis.columns);
  const MatrixXd& c = result.coefficients;
  for (Index i = 0; i < c.cols(); ++i) {
    const double work = c.col(i).dot(by_loads * c.col(i));
    const double energy = c.col(i).dot(by_stiffness * c.col(i));
    result.strain_energy[i] = 0.5 * energy;
    if (work != 0.0) {
      checks.energy =
          std::max(checks.energy, std::abs(energy - work) / std::abs(work));
    }
  }
}

void require(double value, double bound, const char* what,
             const std::string& name) {
  if (value <= bound) return;  // NaN falls through
  throw Error(
      "F003", "part " + name,
      fmt::format("self-check {}: {:.2e}, allowed {:.0e}", what, value, bound),
      "check mesh quality and loads; if they are sound, report this "
      "scene");
}

void require_all(const SolveChecks& checks, int geometry_degree,
                 const std::string& name) {
  require(checks.relief, geometry_degree == 1 ? kReliefFaceted : kRelief,
          "inertia relief", name);
  require(checks.balance, kBalance, "balance of loads", name);
  require(checks.compression, kCompression, "load compression", name);
  require(checks.residual, std::max(kResidual, checks.residual_round_off),
          "residual", name);
  require(checks.equilibrium, kEquilibrium, "support reactions", name);
  require(checks.energy, kEnergy, "energy", name);
}

}  // namespace

template <int dim>
DisplacementBasis<dim> solve(const ElasticProblem<dim>& problem, int degree) {
  Stopwatch watch;
  DisplacementBasis<dim> result;
  result.discretization = discretize(problem.mesh, degree);
  const auto& discretization = result.discretization;
  require_memory(dim, discretization.dofs(), physical_memory(),
                 "part " + problem.name);
  const auto positions = node_positions(discretization);
  const auto stiffness = assemble_stiffness(discretization, problem.material,
                                            "part " + problem.name);
  const bool is_free = problem.fixed.empty();
  const std::vector<int> held =
      is_free ? determinate_supports(discretization, positions)
              : fixed_supports(discretization, positions, problem.fixed,
                               "part " + problem.name);
  MatrixXd history = assemble_loads(discretization, problem.history,
                                    problem.material.density, problem.name);
  if (is_free) {
    balance<dim>(discretization, positions, problem.material.density, history,
                 result.checks);
  }
  const LoadBasis basis = compress(history, kCompressionTolerance);
  result.checks.compression = basis.compression_error;
  result.coefficients = basis.coefficients;
  const auto equation = number_equations(discretization.dofs(), held);
  const UpperTriangle upper = free_equations(stiffness, equation);
  result.seconds.assemble = watch.lap();

  const SparseCholesky cholesky(upper, "part " + problem.name);
  result.seconds.factor = watch.lap();

  result.columns = extend_rows(
      cholesky.solve(restrict_rows(basis.columns, equation, upper.rows())),
      equation);
  check_solution(stiffness, equation, basis, is_free, result);
  result.seconds.solve = watch.lap();
  require_all(result.checks, discretization.geometry_degree, problem.name);
  return result;
}

template DisplacementBasis<2> solve<2>(const ElasticProblem<2>&, int);
template DisplacementBasis<3> solve<3>(const ElasticProblem<3>&, int);

}  // namespace clevis::elasticity
