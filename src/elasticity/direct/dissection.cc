#include "elasticity/direct/dissection.h"

#include <algorithm>
#include <numeric>
#include <span>

#include <Eigen/Geometry>

#include "elasticity/direct/front_merging.h"
#include "elasticity/direct/node_groups.h"
#include "elasticity/direct/separator.h"

namespace clevis::elasticity {
namespace {

template <int dim>
class Dissector {
 public:
  explicit Dissector(const Discretization<dim>& discretization)
      : cell_nodes_(discretization.cell_nodes),
        side_(static_cast<std::size_t>(discretization.nodes), kUnseen),
        separator_(cell_nodes_, side_.size()),
        is_open_(side_.size(), 1) {
    for (const auto& points : discretization.cell_points) {
      centres_.push_back(points.rowwise().mean());
    }
    result_.order.reserve(side_.size());
    seen_.assign(side_.size(), 0);
  }

  Dissection run() {
    std::vector<std::size_t> cells(cell_nodes_.size());
    std::iota(cells.begin(), cells.end(), 0U);
    dissect(cells);
    return std::move(result_);
  }

 private:
  static constexpr int kUnseen = 0, kFirst = 1, kShared = 2, kDone = 3;

  /// Orders the nodes of these cells that no separator holds yet.
  void dissect(std::span<std::size_t> cells) {
    NodeFront front;
    front.border = held_further_up(cells);
    if (cells.size() == 1) {
      front.begin = ordered();
      for (int node : cell_nodes_[cells[0]]) take(node);
      add(std::move(front));
      return;
    }
    split(cells, cells.size() / 2);
    const auto half = separator_.shorten(cells, cells.size() / 2, is_open_);
    std::vector<int> separator;
    for (const std::size_t c : cells.first(half)) mark(c, kUnseen, kFirst);
    for (const std::size_t c : cells.subspan(half)) {
      for (int node : cell_nodes_[c]) {
        int& side = at(node);
        if (side != kFirst) continue;
        side = kShared;
        is_open_[static_cast<std::size_t>(node)] = 0;
        separator.push_back(node);
      }
    }
    for (const std::size_t c : cells.first(half)) mark(c, kFirst, kUnseen);
    dissect(cells.first(half));
    dissect(cells.subspan(half));
    front.children = 2;
    front.begin = ordered();
    for (int node : separator) {
      at(node) = kUnseen;
      take(node);
    }
    add(std::move(front));
  }

  /// Nodes of these cells that separators further up hold.
  std::vector<int> held_further_up(std::span<const std::size_t> cells) {
    ++round_;
    std::vector<int> nodes;
    for (const std::size_t c : cells) {
      for (int node : cell_nodes_[c]) {
        int& seen = seen_[static_cast<std::size_t>(node)];
        if (at(node) != kShared || seen == round_) continue;
        seen = round_;
        nodes.push_back(node);
      }
    }
    return nodes;
  }

  /// Adds and counts the elimination of what was ordered since its begin.
  void add(NodeFront front) {
    front.end = ordered();
    const double n = front.end - front.begin;
    const auto border = static_cast<double>(front.border.size());
    result_.flops += n * (n * n / 3.0 + border * (n + border));
    result_.entries += n * (n + border);
    result_.fronts.push_back(std::move(front));
  }

  int ordered() const { return static_cast<int>(result_.order.size()); }

  /// Halves the cells across their longest extent.
  void split(std::span<std::size_t> cells, std::size_t half) {
    Eigen::AlignedBox<double, dim> box;
    for (const std::size_t c : cells) box.extend(centres_[c]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    std::ranges::nth_element(cells,
                             cells.begin() + static_cast<std::ptrdiff_t>(half),
                             {}, [&](std::size_t c) {
                               return std::pair(centres_[c][axis], c);
                             });
  }

  int& at(int node) { return side_[static_cast<std::size_t>(node)]; }
  void mark(std::size_t cell, int from, int to) {
    for (int node : cell_nodes_[cell]) {
      if (at(node) == from) at(node) = to;
    }
  }
  void take(int node) {
    if (at(node) != kUnseen) return;
    at(node) = kDone;
    result_.order.push_back(node);
  }

  const std::vector<std::vector<int>>& cell_nodes_;
  std::vector<Eigen::Matrix<double, dim, 1>> centres_;
  std::vector<int> side_;
  Separator separator_;
  std::vector<char> is_open_;  ///< nodes that no separator holds yet
  std::vector<int> seen_;      ///< round in which a node was counted
  int round_ = 0;
  Dissection result_;
};

}  // namespace

template <int dim>
Dissection dissect(const Discretization<dim>& discretization) {
  if (discretization.shape == mesh::CellShape::kSimplex) {
    const auto groups =
        grouped_nodes(discretization.cell_nodes, discretization.nodes);
    const auto adjacent = neighbours(groups);
    return fronts_of(groups, adjacent, metis_order(groups, adjacent));
  }
  return Dissector<dim>(discretization).run();
}

template <int dim>
Dissection dissect_and_renumber(Discretization<dim>& discretization,
                                std::vector<int>& place) {
  Dissection dissection = dissect(discretization);
  place.resize(dissection.order.size());
  int next = 0;
  for (int node : dissection.order) {
    place[static_cast<std::size_t>(node)] = next++;
  }
  const auto renumber = [&](std::vector<int>& nodes) {
    for (int& i : nodes) {
      if (i >= 0) i = place[static_cast<std::size_t>(i)];
    }
  };
  for (auto& nodes : discretization.cell_nodes) renumber(nodes);
  for (NodeFront& front : dissection.fronts) renumber(front.border);
  renumber(discretization.vertex_nodes);
  renumber(dissection.order);
  return dissection;
}

template Dissection dissect<2>(const Discretization<2>&);
template Dissection dissect<3>(const Discretization<3>&);
template Dissection dissect_and_renumber<2>(Discretization<2>&,
                                            std::vector<int>&);
template Dissection dissect_and_renumber<3>(Discretization<3>&,
                                            std::vector<int>&);

}  // namespace clevis::elasticity
