#pragma once

#include <vector>

#include "elasticity/discretization.h"

namespace clevis::elasticity {

/// Elimination order of the nodes by nested dissection: the cells are halved
/// across their longest extent again and again, and what both halves share is
/// eliminated after either. Unlike an ordering of the matrix it costs next to
/// nothing and serves any number of unknowns per node.
/// @return nodes in the order in which they are eliminated.
template <int dim>
std::vector<int> dissection_order(const Discretization<dim>& discretization);

/// The order of the equations if node n has `unknowns` in turn: first to last
/// eliminated, held ones left out.
/// @param equation  per unknown; -1: held.
std::vector<int> equation_order(const std::vector<int>& node_order,
                                int unknowns, const std::vector<int>& equation);

}  // namespace clevis::elasticity
