#include "elasticity/plate/layered_solve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/stopwatch.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/direct/memory_forecast.h"
#include "elasticity/nodal_loads/load_vectors.h"
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

/// K or |K| times a block, from the upper triangle; a few columns at a time,
/// which stay in the cache.
template <class Entry>
MatrixXd multiply(const UpperTriangle& upper, const MatrixXd& x,
                  const Entry& entry) {
  constexpr Index kColumns = 16;
  using Rows = Eigen::Matrix<double, kColumns, Eigen::Dynamic>;
  MatrixXd result(x.rows(), x.cols());
  Rows from = Rows::Zero(kColumns, x.rows());
  Rows to(kColumns, x.rows());
  for (Index first = 0; first < x.cols(); first += kColumns) {
    const Index count = std::min(kColumns, x.cols() - first);
    from.topRows(count) = x.middleCols(first, count).transpose();
    to.setZero();
    for (int i = 0; i < upper.rows(); ++i) {
      const auto begin = upper.row_start[static_cast<std::size_t>(i)];
      const auto end = upper.row_start[static_cast<std::size_t>(i) + 1];
      const Eigen::Matrix<double, kColumns, 1> here = from.col(i);
      Eigen::Matrix<double, kColumns, 1> sum = to.col(i);
      for (int k = begin; k < end; ++k) {
        const int j = upper.column[static_cast<std::size_t>(k)];
        const double value = entry(upper.value[static_cast<std::size_t>(k)]);
        sum += value * from.col(j);
        if (j != i) to.col(j) += value * here;
      }
      to.col(i) = sum;
    }
    result.middleCols(first, count) = to.topRows(count).transpose();
  }
  return result;
}

StiffnessAction action_of(const UpperTriangle& upper) {
  return {[&upper](const MatrixXd& x) {
            return multiply(upper, x, [](double value) {
              return value;
            });
          },
          [&upper](const MatrixXd& x) {
            return multiply(upper, x, [](double value) {
              return std::abs(value);
            });
          }};
}

UpperTriangle free_equations(const UpperTriangle& all,
                             const EquationNumbers& numbers) {
  UpperTriangle upper;
  upper.row_start.push_back(0);
  upper.column.reserve(all.column.size());
  upper.value.reserve(all.value.size());
  for (std::size_t i = 0; i < numbers.equation.size(); ++i) {
    if (numbers.equation[i] < 0) continue;
    for (int k = all.row_start[i]; k < all.row_start[i + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const int column =
          numbers.equation[static_cast<std::size_t>(all.column[at])];
      if (column < 0) continue;
      upper.column.push_back(column);
      upper.value.push_back(all.value[at]);
    }
    upper.row_start.push_back(entry_number(upper.column.size()));
  }
  return upper;
}

/// Three vertices far off one line: held across the plate they stop it from
/// moving off its plane and from tilting.
std::vector<int> tripod(const Discretization<2>& plane) {
  const auto n = static_cast<Index>(plane.vertices.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& vertex : plane.vertices) mean += vertex;
  mean /= static_cast<double>(n);
  double size = 0.0;
  for (const auto& vertex : plane.vertices) {
    size = std::max(size, (vertex - mean).norm());
  }
  MatrixXd modes = MatrixXd::Zero(3, n);
  for (Index v = 0; v < n; ++v) {
    const auto k = static_cast<std::size_t>(v);
    if (plane.vertex_nodes[k] < 0) continue;
    const Eigen::Vector2d arm = (plane.vertices[k] - mean) / size;
    modes.col(v) << 1.0, arm.x(), arm.y();
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(modes);
  std::vector<int> nodes;
  for (int k = 0; k < 3; ++k) {
    const auto v = static_cast<std::size_t>(qr.colsPermutation().indices()[k]);
    nodes.push_back(plane.vertex_nodes[v]);
  }
  return nodes;
}

/// Terms that hold the rigid motions of one parity, and no more: their
/// constant ones.
std::vector<int> determinate_terms(const Discretization<2>& plane,
                                   const ThicknessReduction& reduction) {
  const int n = reduction.terms();
  std::vector<int> held;
  if (reduction.parity() == Parity::kStretching) {
    for (int dof : determinate_supports(plane, node_positions(plane))) {
      held.push_back(3 * n * (dof / 2) + n * (dof % 2));
    }
  } else {
    for (int node : tripod(plane)) held.push_back(3 * n * node + 2 * n);
  }
  std::ranges::sort(held);
  return held;
}

/// All terms of the components held on groups.
/// @throws Error F001 if a motion of this parity is left free.
std::vector<int> held_terms(const ElasticProblem<2>& problem,
                            const Discretization<2>& plane,
                            const Discretization<3>& layer,
                            const ThicknessReduction& reduction) {
  const std::string place = "part " + problem.name;
  if (reduction.parity() == Parity::kStretching) {
    fixed_supports(plane, node_positions(plane), problem.fixed, place);
  } else {
    fixed_supports(layer, node_positions(layer), problem.fixed, place);
  }
  const int n = reduction.terms();
  std::vector<int> held;
  for (std::size_t g = 0; g < plane.groups.size(); ++g) {
    const auto entry = problem.fixed.find(plane.groups[g].name);
    if (entry == problem.fixed.end()) continue;
    for (int node : group_nodes(plane, static_cast<int>(g))) {
      for (int c = 0; c < 3; ++c) {
        if (!entry->second[static_cast<std::size_t>(c)]) continue;
        for (int a = 0; a < n; ++a) held.push_back(3 * n * node + n * c + a);
      }
    }
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
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

/// Data that both parities share.
struct Plate {
  const ElasticProblem<2>& problem;
  const Discretization<2>& plane;
  const PlaneIntegrals& integrals;
  const Dissection& dissection;
  std::string place;
};

/// Solves for one parity and adds its columns.
void solve_parity(const Plate& plate, const ThicknessReduction& reduction,
                  const LoadBasis& basis, DisplacementBasis<3>& result) {
  Stopwatch watch;
  const bool is_free = plate.problem.fixed.empty();
  const UpperTriangle stiffness = layered_stiffness(
      plate.integrals, plate.problem.material, reduction.parity(),
      reduction.terms(), plate.plane.thickness);
  const std::vector<int> held =
      is_free ? determinate_terms(plate.plane, reduction)
              : held_terms(plate.problem, plate.plane, result.discretization,
                           reduction);
  const auto numbers = number_equations(stiffness.rows(), held);
  const UpperTriangle upper = free_equations(stiffness, numbers);
  result.seconds.assemble += watch.lap();
  const FrontalCholesky cholesky(
      upper,
      front_tree(plate.dissection, 3 * reduction.terms(), numbers.equation),
      plate.place);
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
          return reduction.reduce(forces_by_strain(result.discretization,
                                                   plate.problem.material,
                                                   reduction.expand(u)));
        },
        action_of(stiffness).multiply_absolute};
    refine(by_strain, cholesky, numbers, basis, terms);
    energy = check_solution(by_strain, terms, basis, held, is_free, checks);
  }
  result.strain_energy += energy;
  require_checks(checks, plate.plane.geometry_degree, plate.problem.name);
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
  LoadBasis history =
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

  const Plate plate{problem, plane, integrals, dissection, place};
  const double all = largest_instant(history);
  int parities = 0;
  for (const Parity parity : {Parity::kStretching, Parity::kBending}) {
    const ThicknessReduction reduction(parity, terms);
    watch.lap();
    const LoadBasis loads = compress(
        LoadBasis{reduction.reduce(history.columns), history.coefficients},
        kCompressionTolerance, all);
    result.seconds.assemble += watch.lap();
    if (largest_instant(loads) <= kNoLoad * all) continue;
    solve_parity(plate, reduction, loads, result);
    ++parities;
  }
  result.is_mirrored = parities < 2;
  return result;
}

}  // namespace clevis::elasticity
