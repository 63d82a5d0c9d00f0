#pragma once

#include <optional>
#include <vector>

#include "mechanism/structure/link_graph.h"

namespace clevis::mechanism {

/// Each lower pair takes two freedoms; a share says from which of its links,
/// none giving more than its three.
struct ConstraintShare {
  int link{};   ///< that gives a freedom
  int other{};  ///< the pair's other link, or kGround
};

/// @return  none if some links have more constraints than freedoms.
std::optional<std::vector<ConstraintShare>> constraint_shares(
    const LinkGraph& graph);

/// Links that fix one another's position: `link`, and every link on which one
/// of them leans. With all freedoms given away they are the fewest links with
/// it that have mobility 0 on ground, whatever the shares.
std::vector<int> leaning_on(const std::vector<ConstraintShare>& shares,
                            int link);

}  // namespace clevis::mechanism
