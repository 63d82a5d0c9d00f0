#include "calculix/node_reduction.h"

#include <algorithm>
#include <array>
#include <span>

#include "elasticity/fe_space/tabulation.h"
#include "mesh/gmsh/gmsh_element.h"

namespace clevis::calculix {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using mesh::CellShape;

/// Reference coordinates of an element's nodes, doubled; CalculiX's order.
using ReferenceNode = std::array<int, 3>;

constexpr std::array<ReferenceNode, 20> kHexahedron = {{
    {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
    {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
    {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1},
}};
constexpr std::array<ReferenceNode, 10> kTetrahedron = {{
    {0, 0, 0},
    {2, 0, 0},
    {0, 2, 0},
    {0, 0, 2},
    {1, 0, 0},
    {1, 1, 0},
    {0, 1, 0},
    {0, 0, 1},
    {1, 0, 1},
    {0, 1, 1},
}};

/// The local function of the degree-2 basis at a reference point.
std::size_t function_at(const elasticity::ReferencePoints<3>& support,
                        const ReferenceNode& doubled) {
  const Eigen::Vector3d at(0.5 * doubled[0], 0.5 * doubled[1],
                           0.5 * doubled[2]);
  Index best = 0;
  (support.colwise() - at).colwise().squaredNorm().minCoeff(&best);
  return static_cast<std::size_t>(best);
}

}  // namespace

NodeReduction::NodeReduction(
    const elasticity::Discretization<3>& discretization)
    : number_(static_cast<std::size_t>(discretization.nodes), -1) {
  const bool is_tensor = discretization.shape == CellShape::kTensor;
  const auto support = elasticity::displacement_support_points<3>(
      discretization.shape, discretization.degree);
  const auto nodes = is_tensor ? std::span<const ReferenceNode>(kHexahedron)
                               : std::span<const ReferenceNode>(kTetrahedron);
  for (const auto& node : nodes) {
    functions_.push_back(function_at(support, node));
  }
  for (const auto& cell : discretization.cell_nodes) {
    for (const std::size_t i : functions_) {
      number_[static_cast<std::size_t>(cell[i])] = 0;
    }
  }
  for (int& number : number_) {
    if (number == 0) number = count_++;
  }
  if (!is_tensor) return;
  for (int k = 0; k < 27; ++k) {
    lexicographic_.push_back(function_at(support, {k % 3, k / 3 % 3, k / 9}));
  }
  const auto order = mesh::hexahedron_node_order(2);
  for (std::size_t a = 0; a < 20; ++a) {
    serendipity_.push_back(lexicographic_[static_cast<std::size_t>(order[a])]);
  }
  std::vector<bool> is_done(number_.size(), false);
  for (const auto& cell : discretization.cell_nodes) follow_in(cell, is_done);
  std::ranges::stable_sort(followers_, {}, &Follower::node);
}

void NodeReduction::follow_in(const std::vector<int>& cell_nodes,
                              std::vector<bool>& is_done) {
  static const MatrixXd complete = mesh::serendipity_to_complete();
  for (std::size_t k = 0; k < lexicographic_.size(); ++k) {
    const int node = cell_nodes[lexicographic_[k]];
    const auto index = static_cast<std::size_t>(node);
    if (number_[index] >= 0 || is_done[index]) continue;
    is_done[index] = true;
    for (std::size_t a = 0; a < serendipity_.size(); ++a) {
      followers_.push_back(
          {node, number(cell_nodes[serendipity_[a]]),
           complete(static_cast<Index>(k), static_cast<Index>(a))});
    }
  }
}

std::vector<std::pair<int, double>> NodeReduction::followed_by(int node) const {
  if (number(node) >= 0) return {{number(node), 1.0}};
  std::vector<std::pair<int, double>> result;
  const auto of_node = std::ranges::equal_range(
      followers_, static_cast<Index>(node), {}, &Follower::node);
  for (const Follower& follower : of_node) {
    if (follower.weight != 0.0) {
      result.emplace_back(follower.to, follower.weight);
    }
  }
  return result;
}

MatrixXd NodeReduction::reduce(const MatrixXd& full) const {
  MatrixXd result = MatrixXd::Zero(3 * count_, full.cols());
  for (std::size_t node = 0; node < number_.size(); ++node) {
    if (number_[node] < 0) continue;
    result.middleRows<3>(3 * number_[node]) +=
        full.middleRows<3>(3 * static_cast<Index>(node));
  }
  for (const auto& [node, to, weight] : followers_) {
    result.middleRows<3>(3 * to) += weight * full.middleRows<3>(3 * node);
  }
  return result;
}

}  // namespace clevis::calculix
