#pragma once

#include <string>
#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Links (welded bodies merged) and lower pairs of a planar mechanism.
struct LinkGraph {
  std::vector<std::string> links;  ///< names, "BC+wheel"; ground is kGround
  struct Pair {
    int a{}, b{};  ///< links
    int joint{};   ///< index into the definition
  };
  std::vector<Pair> pairs;
};

/// @param locked  joints that count as welds too.
LinkGraph link_graph(const MechanismDefinition& definition,
                     const std::vector<int>& locked);

}  // namespace clevis::mechanism
