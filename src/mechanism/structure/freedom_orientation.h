#pragma once

#include <optional>
#include <vector>

#include "mechanism/structure/link_graph.h"

namespace clevis::mechanism {

/// Each lower pair takes two freedoms; a share says from which of its links,
/// none giving more than its three.
struct OrientedFreedom {
  int link{};   ///< that gives a freedom
  int other{};  ///< the pair's other link, or kGround
};

/// @return  none if some links have more constraints than freedoms.
std::optional<std::vector<OrientedFreedom>> freedom_orientation(
    const LinkGraph& graph);

/// Dependency closure of a link: the link, and every link on which one of them
/// depends for its position. With all freedoms given away they are the fewest
/// links with it that have mobility 0 on ground, whatever the shares.
std::vector<int> dependency_closure(const std::vector<OrientedFreedom>& shares,
                                    int link);

}  // namespace clevis::mechanism
