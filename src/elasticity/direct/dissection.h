#pragma once

#include <vector>

#include "elasticity/direct/front_merging.h"
#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// Nested dissection, which serves any number of unknowns per node. Simplices:
/// METIS orders their nodes (metis_order), which takes a quarter of the flops
/// that halving the cells does. Else the cells are halved across their longest
/// extent again and again, there with as short a border as moving single cells
/// gives (Separator), and what both halves share is eliminated after either:
/// on structured cells as good as METIS, and next to free.
template <int dim>
Dissection dissect(const Discretization<dim>& discretization);

/// The same, and renumbers the nodes in the order of their elimination.
/// @param place  of each node, by its former number.
template <int dim>
Dissection dissect_and_renumber(Discretization<dim>& discretization,
                                std::vector<int>& place);

}  // namespace clevis::elasticity
