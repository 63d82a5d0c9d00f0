#pragma once

#include <vector>

#include "elasticity/fe_space/discretization.h"

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

/// Nested dissection: the cells are halved across their longest extent again
/// and again, there with as short a border as moving single cells gives
/// (Separator), and what both halves share is eliminated after either. Unlike
/// an ordering of the matrix it costs next to nothing and serves any number of
/// unknowns per node.
template <int dim>
Dissection dissect(const Discretization<dim>& discretization);

/// The same, and renumbers the nodes in the order of their elimination.
/// @param place  of each node, by its former number.
template <int dim>
Dissection dissect_and_renumber(Discretization<dim>& discretization,
                                std::vector<int>& place);

}  // namespace clevis::elasticity
