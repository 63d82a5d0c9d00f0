#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/structure/link_graph.h"

namespace clevis::mechanism {

/// A kinematic group of zero mobility.
struct AssurGroup {
  std::vector<int> links;
  int group_class{};
  int order{};  ///< pairs that join it to what is already known
};

/// Class by the most complex closed contour of the group: the pairs on one of
/// its links (3 and more) or the links of an inner loop (4 and more), else
/// II.
int contour_class(const LinkGraph& graph, const std::vector<int>& links);

/// Splits the links into groups, the smallest first, each of zero mobility on
/// the links already known (ground, then earlier groups).
/// @return  empty if a remainder does not split.
std::vector<AssurGroup> peel_groups(const LinkGraph& graph);

/// The structural formula with the classes of its groups.
struct AssurFormula {
  std::string text;
  int highest_class{};
};

/// Driven joints are the input and locked.
/// @param taken  joints that are inputs too.
/// @return  empty if the rest does not split.
AssurFormula corrected_formula(const MechanismDefinition& definition,
                               const std::vector<int>& taken);

/// As [LandingGear] (1) does: one link with a pair at ground is the input, all
/// others are taken as one group.
AssurFormula published_formula(const MechanismDefinition& definition);

}  // namespace clevis::mechanism
