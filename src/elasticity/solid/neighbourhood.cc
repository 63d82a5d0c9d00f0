#include "elasticity/solid/neighbourhood.h"

#include <algorithm>
#include <cstddef>

#include "base/system/processor_share.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/foundation.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/tabulation.h"
#include "elasticity/problem/factored_solve.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int kOutside = -1;

/// Numbers of the nodes in the neighbourhood as they come; kOutside elsewhere.
template <int dim>
std::vector<int> number_nodes(const Discretization<dim>& fine,
                              const std::vector<int>& cells, int& nodes) {
  std::vector<int> number(static_cast<std::size_t>(fine.nodes), kOutside);
  nodes = 0;
  for (const int cell : cells) {
    for (const int node : fine.cell_nodes[static_cast<std::size_t>(cell)]) {
      int& n = number[static_cast<std::size_t>(node)];
      if (n == kOutside) n = nodes++;
    }
  }
  return number;
}

/// The cells alone, without groups.
template <int dim>
Discretization<dim> restricted(const Discretization<dim>& fine,
                               const std::vector<int>& cells,
                               const std::vector<int>& number, int nodes) {
  Discretization<dim> part;
  part.shape = fine.shape;
  part.degree = fine.degree;
  part.geometry_degree = fine.geometry_degree;
  part.is_layer = fine.is_layer;
  part.thickness_degree = fine.thickness_degree;
  part.geometry_thickness_degree = fine.geometry_thickness_degree;
  part.is_revolved = fine.is_revolved;
  part.thickness = fine.thickness;
  part.mid_plane_z = fine.mid_plane_z;
  part.nodes = nodes;
  for (const int cell : cells) {
    const auto c = static_cast<std::size_t>(cell);
    auto& ids = part.cell_nodes.emplace_back(fine.cell_nodes[c]);
    for (int& node : ids) node = number[static_cast<std::size_t>(node)];
    part.cell_points.push_back(fine.cell_points[c]);
  }
  return part;
}

/// The lower degree's displacement at the nodes of the neighbourhood.
/// @param cells  of `coarse`.
template <int dim>
MatrixXd carried_over(const EnrichmentProblem<dim>& problem,
                      const std::vector<int>& cells,
                      const Discretization<dim>& part) {
  const auto& coarse = problem.coarse;
  const auto table = tabulate_displacement<dim>(
      coarse.shape, coarse.displacement_degree(),
      displacement_support_points<dim>(part.shape, part.displacement_degree()));
  MatrixXd u(part.dofs(), 1);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& from = coarse.cell_nodes[static_cast<std::size_t>(cells[k])];
    MatrixXd nodal(static_cast<Index>(from.size()), dim);
    for (std::size_t i = 0; i < from.size(); ++i) {
      nodal.row(static_cast<Index>(i)) =
          problem.displacement.template block<dim, 1>(dim * from[i], 0)
              .transpose();
    }
    const MatrixXd values = table.values * nodal;
    for (std::size_t i = 0; i < part.cell_nodes[k].size(); ++i) {
      u.template block<dim, 1>(dim * part.cell_nodes[k][i], 0) =
          values.row(static_cast<Index>(i)).transpose();
    }
  }
  return u;
}

/// Components that keep their value: on the border to the rest of the part,
/// and the supports. Of a neighbourhood without border determinate ones.
template <int dim>
std::vector<int> held_components(const EnrichmentProblem<dim>& problem,
                                 const std::vector<int>& cells,
                                 const std::vector<int>& number) {
  const auto& fine = problem.fine;
  std::vector<int> held;
  for (int c = 0; c < fine.cells(); ++c) {
    if (std::ranges::binary_search(cells, c)) continue;
    for (const int node : fine.cell_nodes[static_cast<std::size_t>(c)]) {
      const int n = number[static_cast<std::size_t>(node)];
      if (n == kOutside) continue;
      for (int d = 0; d < dim; ++d) held.push_back(dim * n + d);
    }
  }
  std::vector<int> supports = problem.held;
  if (held.empty() && supports.empty() && problem.foundations.empty()) {
    supports = determinate_supports<dim>(fine, node_positions<dim>(fine));
  }
  for (const int dof : supports) {
    const int n = number[static_cast<std::size_t>(dof / dim)];
    if (n != kOutside) held.push_back(dim * n + dof % dim);
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

}  // namespace

template <int dim>
std::vector<int> with_neighbours(const Discretization<dim>& fine,
                                 const std::vector<int>& centre) {
  std::vector<char> touched(static_cast<std::size_t>(fine.nodes), 0);
  for (const int cell : centre) {
    for (const int node : fine.cell_nodes[static_cast<std::size_t>(cell)]) {
      touched[static_cast<std::size_t>(node)] = 1;
    }
  }
  std::vector<int> cells;
  for (int c = 0; c < fine.cells(); ++c) {
    if (std::ranges::any_of(fine.cell_nodes[static_cast<std::size_t>(c)],
                            [&](int node) {
                              return touched[static_cast<std::size_t>(node)];
                            })) {
      cells.push_back(c);
    }
  }
  return cells;
}

template <int dim>
Enriched<dim> enrich(const EnrichmentProblem<dim>& problem,
                     const std::vector<int>& cells) {
  Enriched<dim> result;
  int nodes = 0;
  auto number = number_nodes<dim>(problem.fine, cells, nodes);
  auto& part = result.basis.discretization;
  part = restricted<dim>(problem.fine, cells, number, nodes);
  std::vector<int> place;
  const Dissection dissection = dissect_and_renumber(part, place);
  for (int& n : number) {
    if (n != kOutside) n = place[static_cast<std::size_t>(n)];
  }
  MatrixXd load(part.dofs(), 1);
  for (std::size_t node = 0; node < number.size(); ++node) {
    if (number[node] == kOutside) continue;
    load.template block<dim, 1>(dim * number[node], 0) =
        problem.load.template block<dim, 1>(dim * static_cast<Index>(node), 0);
  }
  result.cells = cells;
  if (!problem.coarse_cells.empty()) {
    for (int& cell : result.cells) {
      cell = problem.coarse_cells[static_cast<std::size_t>(cell)];
    }
  }
  MatrixXd u = carried_over<dim>(problem, result.cells, part);
  auto stiffness =
      assemble_stiffness<dim>(part, problem.material, "neighbourhood");
  FoundationStiffness<dim> bed(problem.fine, problem.foundations,
                               "neighbourhood");
  bed.keep(cells);
  bed.renumber(number);
  bed.add_to(stiffness);
  const auto numbers = number_equations(
      part.dofs(), held_components<dim>(problem, cells, number));
  const MatrixXd residual = load - stiffness.multiply(u);
  const auto correction = solve_by_factor(
      free_rows(stiffness, numbers),
      front_tree(dissection, dim, numbers.equation),
      [&](const MatrixXd& x) {
        return restrict_rows(stiffness.multiply(extend_rows(x, numbers)),
                             numbers);
      },
      restrict_rows(residual, numbers), {Precision::kSingle, own_processors()},
      "neighbourhood");
  u += extend_rows(correction.columns, numbers);
  result.basis.columns = std::move(u);
  result.basis.coefficients = MatrixXd::Ones(1, 1);
  return result;
}

template std::vector<int> with_neighbours<2>(const Discretization<2>&,
                                             const std::vector<int>&);
template std::vector<int> with_neighbours<3>(const Discretization<3>&,
                                             const std::vector<int>&);
template Enriched<2> enrich<2>(const EnrichmentProblem<2>&,
                               const std::vector<int>&);
template Enriched<3> enrich<3>(const EnrichmentProblem<3>&,
                               const std::vector<int>&);

}  // namespace clevis::elasticity
