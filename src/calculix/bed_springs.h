#pragma once

#include <vector>

#include "calculix/node_reduction.h"
#include "elasticity/assembly/foundation.h"

namespace clevis::calculix {

/// A linear spring between two components of displacement, or from one to
/// ground.
struct Spring {
  int node{}, component{};
  int other{-1}, other_component{};  ///< node -1: ground
  double stiffness{};                ///< [N/m]
};

/// Springs that together have the stiffness of the beds on the elements' nodes,
/// term by term: of an off-diagonal one −K_ij between two components, and to
/// ground what is left of each row's sum. Some are negative, their sum is not.
/// Terms below 1e-14 of the largest are left out.
std::vector<Spring> bed_springs(const elasticity::FoundationStiffness<3>& beds,
                                const NodeReduction& reduction);

}  // namespace clevis::calculix
