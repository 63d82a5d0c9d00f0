#include "elasticity/direct/front_merging.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace clevis::elasticity {
namespace {

/// Groups that are eliminated together; numbers are places in the order.
struct Node {
  std::vector<int> own;       ///< in the order of elimination
  std::vector<int> border;    ///< later ones that they are coupled to
  std::vector<int> children;  ///< nodes below
  double inner{}, outer{};    ///< mesh nodes of `own` and of `border`
  double zeros{};             ///< entries of the front that merging filled
};

class FrontMerging {
 public:
  FrontMerging(const NodeGroups& groups,
               const std::vector<std::vector<int>>& neighbours,
               const std::vector<int>& order)
      : groups_(groups), neighbours_(neighbours), order_(order) {}

  Dissection run() {
    eliminate();
    for (const int root : roots_) write(root);
    return std::move(result_);
  }

 private:
  double weight(int k) const { return static_cast<double>(nodes_of(k).size()); }
  const std::vector<int>& nodes_of(int k) const {
    const int group = order_[static_cast<std::size_t>(k)];
    return groups_.nodes[static_cast<std::size_t>(group)];
  }
  Node& at(int k) { return tree_[static_cast<std::size_t>(k)]; }

  /// Borders, parents and merging, from the first to the last eliminated.
  void eliminate() {
    const auto n = order_.size();
    std::vector<int> place(n);
    for (std::size_t k = 0; k < n; ++k) {
      place[static_cast<std::size_t>(order_[k])] = static_cast<int>(k);
    }
    tree_.resize(n);
    seen_.assign(n, -1);
    for (int k = 0; k < static_cast<int>(n); ++k) {
      Node& node = at(k);
      node.own = {k};
      node.inner = weight(k);
      seen_[static_cast<std::size_t>(k)] = k;
      const int group = order_[static_cast<std::size_t>(k)];
      for (const int other : neighbours_[static_cast<std::size_t>(group)]) {
        couple(k, place[static_cast<std::size_t>(other)]);
      }
      for (const int child : node.children) {
        for (const int later : at(child).border) couple(k, later);
      }
      merge(node);
      const auto parent = std::ranges::min_element(node.border);
      if (parent == node.border.end()) {
        roots_.push_back(k);
      } else {
        at(*parent).children.push_back(k);
      }
    }
  }

  void couple(int k, int later) {
    int& seen = seen_[static_cast<std::size_t>(later)];
    if (later < k || seen == k) return;
    seen = k;
    at(k).border.push_back(later);
    at(k).outer += weight(later);
  }

  /// Takes over those children whose border is nearly the front's, the most
  /// alike first.
  void merge(Node& node) {
    std::ranges::sort(node.children, std::greater<>(), [&](int child) {
      return std::pair(at(child).outer, child);
    });
    std::vector<int> own, below;
    for (const int k : node.children) {
      Node& child = at(k);
      const double filled =
          child.inner * (node.inner + node.outer - child.outer);
      const double zeros = node.zeros + child.zeros + filled;
      const double inner = node.inner + child.inner;
      if (zeros > allowed(inner) * inner * (inner + node.outer)) {
        below.push_back(k);
        continue;
      }
      node.inner = inner;
      node.zeros = zeros;
      own.insert(own.end(), child.own.begin(), child.own.end());
      below.insert(below.end(), child.children.begin(), child.children.end());
      child = {};
    }
    own.insert(own.end(), node.own.begin(), node.own.end());
    node.own = std::move(own);
    node.children = std::move(below);
  }

  /// Share of zeros in a front [1].
  static double allowed(double inner) {
    constexpr double kSmall = 16.0;  // mesh nodes
    return inner < kSmall ? 0.5 : 0.08;
  }

  /// Adds a node's front behind those below it.
  void write(int root) {
    std::vector<std::pair<int, std::size_t>> path{{root, 0}};
    while (!path.empty()) {
      auto& [k, next] = path.back();
      const Node& node = at(k);
      if (next < node.children.size()) {
        path.emplace_back(node.children[next++], 0);
        continue;
      }
      add(node);
      path.pop_back();
    }
  }

  void add(const Node& node) {
    NodeFront front;
    front.begin = static_cast<int>(result_.order.size());
    for (const int k : node.own) {
      const auto& nodes = nodes_of(k);
      result_.order.insert(result_.order.end(), nodes.begin(), nodes.end());
    }
    front.end = static_cast<int>(result_.order.size());
    front.children = static_cast<int>(node.children.size());
    for (const int k : node.border) {
      const auto& nodes = nodes_of(k);
      front.border.insert(front.border.end(), nodes.begin(), nodes.end());
    }
    const double n = node.inner, border = node.outer;
    result_.flops += n * (n * n / 3.0 + border * (n + border));
    result_.entries += n * (n + border);
    result_.fronts.push_back(std::move(front));
  }

  const NodeGroups& groups_;
  const std::vector<std::vector<int>>& neighbours_;
  const std::vector<int>& order_;
  std::vector<Node> tree_;  ///< by the place of the last of `own`
  std::vector<int> seen_;
  std::vector<int> roots_;
  Dissection result_;
};

}  // namespace

Dissection fronts_of(const NodeGroups& groups,
                     const std::vector<std::vector<int>>& neighbours,
                     const std::vector<int>& order) {
  return FrontMerging(groups, neighbours, order).run();
}

}  // namespace clevis::elasticity
