#include "elasticity/dissection.h"

#include <algorithm>
#include <numeric>
#include <span>

#include <Eigen/Geometry>

namespace clevis::elasticity {
namespace {

template <int dim>
class Dissection {
 public:
  explicit Dissection(const Discretization<dim>& discretization)
      : cell_nodes_(discretization.cell_nodes),
        side_(static_cast<std::size_t>(discretization.nodes), kUnseen) {
    for (const auto& points : discretization.cell_points) {
      centres_.push_back(points.rowwise().mean());
    }
    order_.reserve(side_.size());
  }

  std::vector<int> order() {
    std::vector<std::size_t> cells(cell_nodes_.size());
    std::iota(cells.begin(), cells.end(), 0U);
    dissect(cells);
    return std::move(order_);
  }

 private:
  static constexpr int kUnseen = 0, kFirst = 1, kShared = 2, kDone = 3;

  /// Orders the nodes of these cells that no separator holds yet.
  void dissect(std::span<std::size_t> cells) {
    if (cells.size() == 1) {
      for (int node : cell_nodes_[cells[0]]) take(node);
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
    for (int node : separator) {
      at(node) = kUnseen;
      take(node);
    }
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
    order_.push_back(node);
  }

  const std::vector<std::vector<int>>& cell_nodes_;
  std::vector<Eigen::Matrix<double, dim, 1>> centres_;
  std::vector<int> side_;
  std::vector<int> order_;
};

}  // namespace

template <int dim>
std::vector<int> dissection_order(const Discretization<dim>& discretization) {
  return Dissection<dim>(discretization).order();
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

template std::vector<int> dissection_order<2>(const Discretization<2>&);
template std::vector<int> dissection_order<3>(const Discretization<3>&);

}  // namespace clevis::elasticity
