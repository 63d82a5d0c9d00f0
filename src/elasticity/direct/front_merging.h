#pragma once

#include <vector>

#include "elasticity/direct/node_groups.h"

namespace clevis::elasticity {

/// Nodes that are eliminated together once all below them are.
struct NodeFront {
  int begin{}, end{};       ///< of Dissection::order
  int children{};           ///< fronts just below it
  std::vector<int> border;  ///< nodes further up that they are coupled to
};

/// Elimination order of the nodes, and what a dense Cholesky factor of each
/// separator costs with one unknown per node: flops grow with the cube,
/// entries with the square of the unknowns.
struct Dissection {
  std::vector<int> order;  ///< nodes, first to last eliminated
  /// Of `order`, each behind those below it.
  std::vector<NodeFront> fronts;
  double flops{};
  double entries{};  ///< of the factor
};

/// The fronts that an order of elimination makes: groups whose elimination
/// couples the same later ones are taken together, and others where that fills
/// few entries with zeros, for arithmetic of large blocks is the quicker.
/// @param order  of the groups.
/// Source: [Liu1992].
Dissection fronts_of(const NodeGroups& groups,
                     const std::vector<std::vector<int>>& neighbours,
                     const std::vector<int>& order);

}  // namespace clevis::elasticity
