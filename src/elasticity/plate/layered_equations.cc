#include "elasticity/plate/layered_equations.h"

#include <algorithm>

#include <Eigen/QR>

#include "base/system/processor_share.h"
#include "elasticity/assembly/supports.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

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
std::vector<int> held_terms(const Plate& plate,
                            const ThicknessReduction& reduction) {
  const Discretization<2>& plane = plate.plane;
  const std::string place = "part " + plate.name;
  if (reduction.parity() == Parity::kStretching) {
    fixed_supports(plane, node_positions(plane), plate.fixed, place);
  } else {
    fixed_supports(plate.layer, node_positions(plate.layer), plate.fixed,
                   place);
  }
  const int n = reduction.terms();
  std::vector<int> held;
  for (std::size_t g = 0; g < plane.groups.size(); ++g) {
    const auto entry = plate.fixed.find(plane.groups[g].name);
    if (entry == plate.fixed.end()) continue;
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

}  // namespace

LayeredEquations layered_equations(const Plate& plate,
                                   const ThicknessReduction& reduction) {
  LayeredEquations equations;
  equations.stiffness =
      layered_stiffness(plate.integrals, plate.material, reduction.parity(),
                        reduction.terms(), plate.plane.thickness);
  equations.held = plate.fixed.empty()
                       ? determinate_terms(plate.plane, reduction)
                       : held_terms(plate, reduction);
  equations.numbers =
      number_equations(equations.stiffness.rows(), equations.held);
  return equations;
}

FrontalCholesky factored(const LayeredEquations& equations,
                         const Dissection& dissection,
                         const ThicknessReduction& reduction,
                         const std::string& place) {
  return {
      free_equations(equations.stiffness, equations.numbers),
      front_tree(dissection, 3 * reduction.terms(), equations.numbers.equation),
      place, own_processors()};
}

}  // namespace clevis::elasticity
