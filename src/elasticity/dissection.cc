#include "elasticity/dissection.h"

#include <algorithm>
#include <numeric>
#include <span>

#include <Eigen/Geometry>

namespace clevis::elasticity {
namespace {

template <int dim>
class Dissector {
 public:
  explicit Dissector(const Discretization<dim>& discretization)
      : cell_nodes_(discretization.cell_nodes),
        side_(static_cast<std::size_t>(discretization.nodes), kUnseen) {
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
    const double border = count_shared(cells);
    const std::size_t before = result_.order.size();
    if (cells.size() == 1) {
      for (int node : cell_nodes_[cells[0]]) take(node);
      count(before, border);
      return;
    }
    const auto half = cells.size() / 2;
    split(cells, half);
    std::vector<int> separator;
    for (const std::size_t c : cells.first(half)) mark(c, kUnseen, kFirst);
    for (const std::size_t c : cells.subspan(half)) {
      for (int node : cell_nodes_[c]) {
        int& side = at(node);
        if (side != kFirst) continue;
        side = kShared;
        separator.push_back(node);
      }
    }
    for (const std::size_t c : cells.first(half)) mark(c, kFirst, kUnseen);
    dissect(cells.first(half));
    dissect(cells.subspan(half));
    const std::size_t inside = result_.order.size();
    for (int node : separator) {
      at(node) = kUnseen;
      take(node);
    }
    count(inside, border);
  }

  /// Nodes of these cells that separators further up hold.
  double count_shared(std::span<const std::size_t> cells) {
    ++round_;
    int count = 0;
    for (const std::size_t c : cells) {
      for (int node : cell_nodes_[c]) {
        int& seen = seen_[static_cast<std::size_t>(node)];
        if (at(node) != kShared || seen == round_) continue;
        seen = round_;
        ++count;
      }
    }
    return count;
  }

  /// Counts the elimination of what was ordered since, with so many nodes of
  /// the border to update.
  void count(std::size_t since, double border) {
    const auto n = static_cast<double>(result_.order.size() - since);
    result_.flops += n * (n * n / 3.0 + border * (n + border));
    result_.entries += n * (0.5 * n + border);
  }

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
  std::vector<int> seen_;  ///< round in which a node was counted
  int round_ = 0;
  Dissection result_;
};

}  // namespace

template <int dim>
Dissection dissect(const Discretization<dim>& discretization) {
  return Dissector<dim>(discretization).run();
}

std::vector<int> equation_order(const std::vector<int>& node_order,
                                int unknowns,
                                const std::vector<int>& equation) {
  std::vector<int> order;
  order.reserve(equation.size());
  for (int node : node_order) {
    for (int a = 0; a < unknowns; ++a) {
      const int number =
          equation[static_cast<std::size_t>(unknowns * node + a)];
      if (number >= 0) order.push_back(number);
    }
  }
  return order;
}

template Dissection dissect<2>(const Discretization<2>&);
template Dissection dissect<3>(const Discretization<3>&);

}  // namespace clevis::elasticity
