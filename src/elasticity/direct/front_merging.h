#pragma once

#include <vector>

#include "elasticity/direct/node_fronts.h"
#include "elasticity/direct/node_groups.h"

namespace clevis::elasticity {

/// The fronts that an order of elimination makes: groups whose elimination
/// couples the same later ones are taken together, and others where that fills
/// few entries with zeros, for arithmetic of large blocks is the quicker.
/// @param order  of the groups.
/// Source: [Liu1992].
Dissection fronts_of(const NodeGroups& groups,
                     const std::vector<std::vector<int>>& neighbours,
                     const std::vector<int>& order);

}  // namespace clevis::elasticity
