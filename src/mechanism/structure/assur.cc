#include "mechanism/structure/assur.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mechanism/structure/freedom_orientation.h"
#include "mechanism/structure/link_graph.h"

namespace clevis::mechanism {
namespace {

bool contains(const std::vector<int>& links, int link) {
  return std::ranges::find(links, link) != links.end();
}

/// Longest loop of links inside the group, 0 without one.
int longest_loop(const LinkGraph& graph, const std::vector<int>& links,
                 int start, int here, std::vector<int>& path) {
  int longest = 0;
  for (const LinkGraph::Pair& pair : graph.pairs) {
    if (pair.a != here && pair.b != here) continue;
    const int next = pair.a == here ? pair.b : pair.a;
    if (!contains(links, next)) continue;
    if (next == start && path.size() >= 3) {
      longest = std::max(longest, static_cast<int>(path.size()));
    }
    if (contains(path, next)) continue;
    path.push_back(next);
    longest = std::max(longest, longest_loop(graph, links, start, next, path));
    path.pop_back();
  }
  return longest;
}

/// Smallest set of free links with mobility 0 on the known ones; of equal
/// ones that with the first links.
std::vector<int> smallest_group(const std::vector<OrientedFreedom>& shares,
                                const std::vector<int>& free) {
  std::vector<int> smallest;
  for (const int link : free) {
    std::vector<int> links = dependency_closure(shares, link);
    std::erase_if(links, [&free](int known) {
      return !contains(free, known);
    });
    if (smallest.empty() || links.size() < smallest.size() ||
        (links.size() == smallest.size() && links < smallest)) {
      smallest = links;
    }
  }
  return smallest;
}

std::string group_text(const LinkGraph& graph, int group_class,
                       const std::vector<int>& links) {
  static const char* const kRoman[] = {"0",  "I",   "II",   "III", "IV", "V",
                                       "VI", "VII", "VIII", "IX",  "X"};
  std::vector<std::string> names;
  for (const int link : links) {
    names.push_back(graph.links[static_cast<std::size_t>(link)]);
  }
  return fmt::format(
      "{}({})",
      group_class <= 10 ? kRoman[group_class] : fmt::format("{}", group_class),
      fmt::join(names, ","));
}

std::vector<int> all_links(const LinkGraph& graph) {
  std::vector<int> links(graph.links.size());
  std::iota(links.begin(), links.end(), 0);
  return links;
}

}  // namespace

int contour_class(const LinkGraph& graph, const std::vector<int>& links) {
  int result = 2;
  for (const int link : links) {
    const auto on_link =
        std::ranges::count_if(graph.pairs, [link](const LinkGraph::Pair& pair) {
          return pair.a == link || pair.b == link;
        });
    result = std::max(result, static_cast<int>(on_link));
    std::vector<int> path{link};
    const int loop = longest_loop(graph, links, link, link, path);
    if (loop >= 4) result = std::max(result, loop);
  }
  return result;
}

std::vector<AssurGroup> peel_groups(const LinkGraph& graph) {
  const auto shares = freedom_orientation(graph);
  if (!shares || shares->size() != 3 * graph.links.size()) return {};
  std::vector<AssurGroup> groups;
  std::vector<int> known{kGround};
  std::vector<int> free = all_links(graph);
  while (!free.empty()) {
    const std::vector<int> links = smallest_group(*shares, free);
    LinkGraph visible = graph;  // pairs to links that come later do not count
    std::erase_if(visible.pairs, [&](const LinkGraph::Pair& pair) {
      const auto seen = [&](int link) {
        return contains(links, link) || contains(known, link);
      };
      return !seen(pair.a) || !seen(pair.b);
    });
    const auto order =
        std::ranges::count_if(visible.pairs, [&](const LinkGraph::Pair& pair) {
          return contains(links, pair.a) != contains(links, pair.b);
        });
    groups.push_back({.links = links,
                      .group_class = contour_class(visible, links),
                      .order = static_cast<int>(order)});
    known.insert(known.end(), links.begin(), links.end());
    std::erase_if(free, [&](int link) {
      return contains(links, link);
    });
  }
  return groups;
}

AssurFormula corrected_formula(const MechanismDefinition& definition,
                               const std::vector<int>& taken) {
  std::vector<int> locked;
  for (const DriveDefinition& drive : definition.drives) {
    locked.push_back(drive.joint);
  }
  locked.insert(locked.end(), taken.begin(), taken.end());
  std::vector<std::string> inputs;
  for (const int joint : locked) {
    inputs.push_back(definition.joints[static_cast<std::size_t>(joint)].name);
  }
  const LinkGraph graph = link_graph(definition, locked);
  AssurFormula formula{fmt::format("I({})", fmt::join(inputs, ",")), 1};
  const std::vector<AssurGroup> groups = peel_groups(graph);
  if (groups.empty() && !graph.links.empty()) return {};
  for (const AssurGroup& group : groups) {
    formula.text += " -> " + group_text(graph, group.group_class, group.links);
    formula.highest_class = std::max(formula.highest_class, group.group_class);
  }
  return formula;
}

AssurFormula published_formula(const MechanismDefinition& definition) {
  LinkGraph graph = link_graph(definition, {});
  if (definition.drives.size() != 1) return {};
  const auto driven = std::ranges::find(graph.pairs, definition.drives[0].joint,
                                        &LinkGraph::Pair::joint);
  if (driven == graph.pairs.end()) return {};
  const auto at_ground = [&graph](int link) {
    return std::ranges::any_of(graph.pairs, [link](const auto& pair) {
      return (pair.a == kGround && pair.b == link) ||
             (pair.b == kGround && pair.a == link);
    });
  };
  const int input = driven->a != kGround && at_ground(driven->a) ? driven->a
                    : driven->b != kGround                       ? driven->b
                                                                 : driven->a;
  std::vector<int> rest = all_links(graph);
  std::erase(rest, input);
  // the input's own pair at ground is not one of the group's
  std::erase_if(graph.pairs, [&](const LinkGraph::Pair& pair) {
    return !contains(rest, pair.a) && !contains(rest, pair.b);
  });
  AssurFormula formula{group_text(graph, 1, {input}), 1};
  if (rest.empty()) return formula;
  formula.highest_class = contour_class(graph, rest);
  formula.text += " -> " + group_text(graph, formula.highest_class, rest);
  return formula;
}

}  // namespace clevis::mechanism
