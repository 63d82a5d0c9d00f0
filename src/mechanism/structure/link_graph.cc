#include "mechanism/structure/link_graph.h"

#include <algorithm>
#include <numeric>

#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

LinkGraph link_graph(const MechanismDefinition& definition,
                     const std::vector<int>& locked) {
  const int n = static_cast<int>(definition.bodies.size());
  std::vector<int> leader(static_cast<std::size_t>(n) + 1);  // n: ground
  std::iota(leader.begin(), leader.end(), 0);
  const auto slot = [n](BodyIndex body) {
    return static_cast<std::size_t>(body == kGround ? n : body);
  };
  const auto merged = [&](int j) {
    return traits(definition.joints[static_cast<std::size_t>(j)].type)
               .merges_links ||
           std::ranges::find(locked, j) != locked.end();
  };
  const int joints = static_cast<int>(definition.joints.size());
  for (int j = 0; j < joints; ++j) {
    if (!merged(j)) continue;
    const auto& joint = definition.joints[static_cast<std::size_t>(j)];
    const int from = leader[slot(joint.body_a)];
    const int to = leader[slot(joint.body_b)];
    const bool from_ground = from == leader[slot(kGround)];
    const int kept = from_ground ? from : to, dropped = from_ground ? to : from;
    std::ranges::replace(leader, dropped, kept);
  }
  LinkGraph graph;
  std::vector<int> link_of(leader.size(), kGround);
  for (int body = 0; body < n; ++body) {
    const int l = leader[slot(body)];
    if (l == leader[slot(kGround)]) continue;
    const auto& name = definition.bodies[static_cast<std::size_t>(body)].name;
    auto& link = link_of[static_cast<std::size_t>(l)];
    if (link == kGround) {
      link = static_cast<int>(graph.links.size());
      graph.links.push_back(name);
    } else {
      graph.links[static_cast<std::size_t>(link)] += "+" + name;
    }
  }
  for (int j = 0; j < joints; ++j) {
    if (merged(j)) continue;
    const auto& joint = definition.joints[static_cast<std::size_t>(j)];
    const auto link = [&](BodyIndex body) {
      return link_of[static_cast<std::size_t>(leader[slot(body)])];
    };
    graph.pairs.push_back({link(joint.body_a), link(joint.body_b), j});
  }
  return graph;
}

}  // namespace clevis::mechanism
