#include "elasticity/direct/front_tree.h"

#include <algorithm>

namespace clevis::elasticity {
namespace {

/// Fronts below this size cost more to call than to compute.
constexpr int kSmallFront = 96;

/// A front and all below it.
struct Subtree {
  int begin;          ///< its first unknown
  std::size_t first;  ///< its first front
};

/// Where the unknowns of each node stand in the order of elimination.
struct Places {
  std::vector<int> first;  ///< per node of the order, and behind the last
  std::vector<int> rank;   ///< per node: its place in the order
};

Places number(const Dissection& dissection, int unknowns,
              const std::vector<int>& equation, std::vector<int>& place) {
  Places places;
  places.rank.resize(dissection.order.size());
  int next = 0;
  for (std::size_t k = 0; k < dissection.order.size(); ++k) {
    const int node = dissection.order[k];
    places.rank[static_cast<std::size_t>(node)] = static_cast<int>(k);
    places.first.push_back(next);
    for (int a = 0; a < unknowns; ++a) {
      const int e = equation[static_cast<std::size_t>(unknowns * node + a)];
      if (e >= 0) place[static_cast<std::size_t>(e)] = next++;
    }
  }
  places.first.push_back(next);
  return places;
}

std::vector<int> border_of(const NodeFront& front, const Places& places) {
  std::vector<int> ranks;
  ranks.reserve(front.border.size());
  for (int node : front.border) {
    ranks.push_back(places.rank[static_cast<std::size_t>(node)]);
  }
  std::ranges::sort(ranks);
  std::vector<int> border;
  for (int rank : ranks) {
    const auto k = static_cast<std::size_t>(rank);
    for (int i = places.first[k]; i < places.first[k + 1]; ++i) {
      border.push_back(i);
    }
  }
  return border;
}

}  // namespace

FrontTree front_tree(const Dissection& dissection, int unknowns,
                     const std::vector<int>& equation) {
  FrontTree tree;
  tree.place.resize(
      static_cast<std::size_t>(std::ranges::count_if(equation, [](int e) {
        return e >= 0;
      })));
  const Places places = number(dissection, unknowns, equation, tree.place);
  const auto first = [&](int rank) {
    return places.first[static_cast<std::size_t>(rank)];
  };
  std::vector<Subtree> waiting;  // for their parent
  for (const NodeFront& nodes : dissection.fronts) {
    Front front{first(nodes.begin), first(nodes.end), border_of(nodes, places),
                nodes.children};
    Subtree subtree{front.begin, tree.fronts.size()};
    for (int child = 0; child < nodes.children; ++child) {
      subtree = waiting.back();
      waiting.pop_back();
    }
    if (front.end - subtree.begin + front.later() <= kSmallFront) {
      tree.fronts.resize(subtree.first);
      front.begin = subtree.begin;
      front.children = 0;
    }
    waiting.push_back(subtree);
    tree.fronts.push_back(std::move(front));
  }
  return tree;
}

std::size_t FrontTree::factor_entries() const {
  std::size_t entries = 0;
  for (const Front& front : fronts) entries += front.panel_entries();
  return entries;
}

std::size_t stack_entries(std::span<const Front> fronts) {
  std::vector<std::size_t> standing;
  std::size_t now = 0;
  std::size_t most = 0;
  for (const Front& front : fronts) {
    now += front.border_entries();
    most = std::max(most, now);  // beside those of its children
    for (int child = 0; child < front.children; ++child) {
      now -= standing.back();
      standing.pop_back();
    }
    standing.push_back(front.border_entries());
  }
  return most;
}

std::vector<std::size_t> first_below(const std::vector<Front>& fronts) {
  std::vector<std::size_t> first, waiting;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    std::size_t lowest = f;
    for (int child = 0; child < fronts[f].children; ++child) {
      lowest = waiting.back();
      waiting.pop_back();
    }
    waiting.push_back(lowest);
    first.push_back(lowest);
  }
  return first;
}

}  // namespace clevis::elasticity
