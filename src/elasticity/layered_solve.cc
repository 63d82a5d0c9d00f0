#include "elasticity/layered_solve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/stopwatch.h"
#include "elasticity/dissection.h"
#include "elasticity/equations.h"
#include "elasticity/layered_stiffness.h"
#include "elasticity/load_vectors.h"
#include "elasticity/memory_forecast.h"
#include "elasticity/plate_layer.h"
#include "elasticity/supports.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kCompressionTolerance = 3e-7;
/// Loads of a parity below this part of all are round-off of the other's.
constexpr double kNoLoad = 1e-10;

/// K or |K| times a block, from the upper triangle.
template <class Entry>
MatrixXd multiply(const UpperTriangle& upper, const MatrixXd& x,
                  const Entry& entry) {
  using RowMajor =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMajor rows = x;
  RowMajor y = RowMajor::Zero(x.rows(), x.cols());
  for (int i = 0; i < upper.rows(); ++i) {
    const auto begin = upper.row_start[static_cast<std::size_t>(i)];
    const auto end = upper.row_start[static_cast<std::size_t>(i) + 1];
    for (int k = begin; k < end; ++k) {
      const int j = upper.column[static_cast<std::size_t>(k)];
      const double value = entry(upper.value[static_cast<std::size_t>(k)]);
      y.row(i) += value * rows.row(j);
      if (j != i) y.row(j) += value * rows.row(i);
    }
  }
  return y;
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
    upper.row_start.push_back(static_cast<int>(upper.column.size()));
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

/// All terms of the components held on the layer's groups.
std::vector<int> held_terms(const std::vector<int>& layer_held, int terms) {
  std::vector<int> held;
  const int heights = 2 * terms;
  for (int dof : layer_held) {
    const int node = dof / 3 / heights;
    for (int a = 0; a < terms; ++a) {
      held.push_back(3 * terms * node + terms * (dof % 3) + a);
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

/// What both parities share.
struct Plate {
  const ElasticProblem<2>& problem;
  const Discretization<2>& plane;
  const PlaneIntegrals& integrals;
  const std::vector<int>& layer_held;  ///< empty: a free part
  const std::vector<int> node_order;
  std::string place;
};

/// Solves for one parity and adds its columns.
void solve_parity(const Plate& plate, const ThicknessReduction& reduction,
                  const MatrixXd& loads, DisplacementBasis<3>& result) {
  Stopwatch watch;
  const bool is_free = plate.problem.fixed.empty();
  const UpperTriangle stiffness = layered_stiffness(
      plate.integrals, plate.problem.material, reduction.parity(),
      reduction.terms(), plate.plane.thickness);
  const std::vector<int> held =
      is_free ? determinate_terms(plate.plane, reduction)
              : held_terms(plate.layer_held, reduction.terms());
  const LoadBasis basis = compress(loads, kCompressionTolerance);
  const auto numbers = number_equations(stiffness.rows(), held);
  const UpperTriangle upper = free_equations(stiffness, numbers);
  result.seconds.assemble += watch.lap();
  const SparseCholesky cholesky(
      upper, plate.place,
      equation_order(plate.node_order, 3 * reduction.terms(),
                     numbers.equation));
  result.seconds.factor += watch.lap();
  const MatrixXd terms = extend_rows(
      cholesky.solve(restrict_rows(basis.columns, numbers)), numbers);
  SolveChecks checks = result.checks;
  checks.compression = basis.compression_error;
  result.strain_energy +=
      check_solution(action_of(stiffness), terms, basis, held, is_free, checks);
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
  const auto plane = discretize(problem.mesh, degree);
  DisplacementBasis<3> result;
  result.discretization = layer_over(plane, 2 * terms - 1);
  const auto& layer = result.discretization;
  require_memory(3, 3.0 * terms * plane.nodes, physical_memory(), place);
  const auto positions = node_positions(layer);
  const bool is_free = problem.fixed.empty();
  MatrixXd history =
      assemble_loads(layer, problem.history, density, problem.name);
  std::vector<int> layer_held;
  if (is_free) {
    balance_free_part<3>(layer, positions, density, history, result.checks);
  } else {
    layer_held = fixed_supports(layer, positions, problem.fixed, place);
  }
  const auto integrals = plane_integrals(plane, place);
  result.columns.resize(layer.dofs(), 0);
  result.coefficients.resize(0, history.cols());
  result.strain_energy = Eigen::VectorXd::Zero(history.cols());
  result.seconds.assemble = watch.lap();

  const Plate plate{
      problem, plane, integrals, layer_held, dissection_order(plane), place};
  const double all = history.colwise().norm().maxCoeff();
  for (const Parity parity : {Parity::kStretching, Parity::kBending}) {
    const ThicknessReduction reduction(parity, terms);
    watch.lap();
    const MatrixXd loads = reduction.reduce(history);
    result.seconds.assemble += watch.lap();
    if (loads.colwise().norm().maxCoeff() <= kNoLoad * all) continue;
    solve_parity(plate, reduction, loads, result);
  }
  return result;
}

}  // namespace clevis::elasticity
