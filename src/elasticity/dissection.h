#pragma once

#include <vector>

#include "elasticity/discretization.h"

namespace clevis::elasticity {

/// Elimination order of the nodes, and what a dense Cholesky factor of each
/// separator would cost with one unknown per node: flops grow with the cube,
/// entries with the square of the unknowns.
struct Dissection {
  std::vector<int> order;  ///< nodes, first to last eliminated
  double flops{};
  double entries{};  ///< of the factor's lower triangle
};

/// Nested dissection: the cells are halved across their longest extent again
/// and again, and what both halves share is eliminated after either. Unlike an
/// ordering of the matrix it costs next to nothing and serves any number of
/// unknowns per node.
template <int dim>
Dissection dissect(const Discretization<dim>& discretization);

/// The order of the equations if node n has `unknowns` in turn: first to last
/// eliminated, held ones left out.
/// @param equation  per unknown; -1: held.
std::vector<int> equation_order(const std::vector<int>& node_order,
                                int unknowns, const std::vector<int>& equation);

}  // namespace clevis::elasticity
