#include "elasticity/fe_space/tensor_numbering.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "mesh/basis/cell_parts.h"

namespace clevis::elasticity {
namespace {

constexpr unsigned kNone = ~0U;
using Corners = std::array<unsigned, 4>;  // vertices, kNone where fewer

struct CornersHash {
  std::size_t operator()(const Corners& corners) const {
    std::size_t hash = 0;
    for (const unsigned corner : corners) {
      hash = (hash ^ corner) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

/// Nodes of an edge or a face, as the cell that met it first has them.
struct SharedPart {
  int first{};
  Corners corners{};
};

Corners corners_of(const std::vector<unsigned>& cell,
                   const mesh::CellPart& part) {
  Corners corners = {kNone, kNone, kNone, kNone};
  for (unsigned k = 0; k < (1U << part.along.size()); ++k) {
    corners[k] = cell[mesh::corner_of(part, k)];
  }
  return corners;
}

/// Number along the first cell's directions of the node (i, j) of another's.
int shared_number(const Corners& first, const Corners& own, int inner,
                  std::array<int, 2> node) {
  const auto origin =
      static_cast<unsigned>(std::ranges::find(own, first[0]) - own.begin());
  const auto next =
      static_cast<unsigned>(std::ranges::find(own, first[1]) - own.begin());
  for (unsigned k = 0; k < 2; ++k) {
    if (((origin >> k) & 1U) != 0) node[k] = inner - 1 - node[k];
  }
  const bool is_swapped = (origin ^ next) == 2U;
  return is_swapped ? node[1] + inner * node[0] : node[0] + inner * node[1];
}

template <int dim>
class Numbering {
 public:
  Numbering(std::size_t vertices, int degree) : inner_(degree - 1) {
    result_.vertex_nodes.assign(vertices, -1);
  }

  void take(const std::vector<unsigned>& cell) {
    auto& nodes = result_.cell_nodes.emplace_back();
    for (const mesh::CellPart& part : mesh::cell_parts<dim>()) {
      if (part.along.empty()) {
        int& node = result_.vertex_nodes[cell[part.corner]];
        if (node < 0) node = result_.nodes++;
        nodes.push_back(node);
      } else if (part.along.size() == dim) {
        int count = 1;
        for (int d = 0; d < dim; ++d) count *= inner_;
        for (int k = 0; k < count; ++k) nodes.push_back(result_.nodes++);
      } else if (inner_ > 0) {
        take_shared(cell, part, nodes);
      }
    }
  }
  TensorNumbering finish() { return std::move(result_); }

 private:
  void take_shared(const std::vector<unsigned>& cell,
                   const mesh::CellPart& part, std::vector<int>& nodes) {
    const Corners own = corners_of(cell, part);
    Corners key = own;
    std::ranges::sort(key);
    const int rows = part.along.size() == 1 ? 1 : inner_;
    const auto [at, added] =
        shared_.try_emplace(key, SharedPart{result_.nodes, own});
    if (added) result_.nodes += rows * inner_;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < inner_; ++i) {
        nodes.push_back(at->second.first +
                        shared_number(at->second.corners, own, inner_, {i, j}));
      }
    }
  }

  int inner_;  ///< nodes inside an edge
  TensorNumbering result_;
  std::unordered_map<Corners, SharedPart, CornersHash> shared_;
};

}  // namespace

template <int dim>
TensorNumbering number_tensor_cells(
    const std::vector<std::vector<unsigned>>& cells, std::size_t vertices,
    int degree) {
  Numbering<dim> numbering(vertices, degree);
  for (const auto& cell : cells) numbering.take(cell);
  return numbering.finish();
}

template TensorNumbering number_tensor_cells<2>(
    const std::vector<std::vector<unsigned>>&, std::size_t, int);
template TensorNumbering number_tensor_cells<3>(
    const std::vector<std::vector<unsigned>>&, std::size_t, int);

}  // namespace clevis::elasticity
