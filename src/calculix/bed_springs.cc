#include "calculix/bed_springs.h"

#include <cmath>
#include <map>
#include <utility>

namespace clevis::calculix {
namespace {

using Eigen::Index;
using Degree = std::pair<int, int>;  // node, component

/// The stiffness on the elements' nodes, its upper triangle [N/m].
std::map<std::pair<Degree, Degree>, double> stiffness_of(
    const elasticity::FoundationStiffness<3>& beds,
    const NodeReduction& reduction) {
  std::map<std::pair<Degree, Degree>, double> stiffness;
  for (const auto& face : beds.faces()) {
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      for (std::size_t j = 0; j < face.nodes.size(); ++j) {
        const auto block = face.matrix.block<3, 3>(3 * static_cast<Index>(i),
                                                   3 * static_cast<Index>(j));
        for (const auto& [a, share_a] : reduction.followed_by(face.nodes[i])) {
          for (const auto& [b, share_b] :
               reduction.followed_by(face.nodes[j])) {
            for (int c = 0; c < 3; ++c) {
              for (int d = 0; d < 3; ++d) {
                const Degree row{a, c}, column{b, d};
                if (column < row) continue;
                stiffness[{row, column}] += share_a * share_b * block(c, d);
              }
            }
          }
        }
      }
    }
  }
  return stiffness;
}

}  // namespace

std::vector<Spring> bed_springs(const elasticity::FoundationStiffness<3>& beds,
                                const NodeReduction& reduction) {
  constexpr double kNothing = 1e-14;
  const auto stiffness = stiffness_of(beds, reduction);
  double largest = 0.0;
  for (const auto& [place, value] : stiffness) {
    largest = std::max(largest, std::abs(value));
  }
  std::map<Degree, double> to_ground;
  std::vector<Spring> springs;
  for (const auto& [place, value] : stiffness) {
    const auto& [row, column] = place;
    to_ground[row] += value;
    if (row == column) continue;
    to_ground[column] += value;
    if (std::abs(value) > kNothing * largest) {
      springs.push_back(
          {row.first, row.second, column.first, column.second, -value});
    }
  }
  for (const auto& [at, value] : to_ground) {
    if (std::abs(value) > kNothing * largest) {
      springs.push_back({at.first, at.second, -1, 0, value});
    }
  }
  return springs;
}

}  // namespace clevis::calculix
