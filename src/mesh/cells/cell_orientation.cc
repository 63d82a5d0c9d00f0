#include "mesh/cells/cell_orientation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>

#include "mesh/basis/cell_parts.h"

namespace clevis::mesh {
namespace {

using Cell = std::vector<unsigned>;

/// An edge of a cell: from `corner` along `direction`.
struct LocalEdge {
  unsigned corner{};
  int direction{};
};

template <int dim>
std::vector<LocalEdge> edges_of_a_cell() {
  std::vector<LocalEdge> edges;
  for (const CellPart& part : cell_parts<dim>()) {
    if (part.along.size() == 1) edges.push_back({part.corner, part.along[0]});
  }
  return edges;
}

/// The edges of all cells.
template <int dim>
class Edges {
 public:
  static constexpr int kPerCell = dim == 2 ? 4 : 12;

  explicit Edges(const std::vector<Cell>& cells)
      : cells_(cells), local_(edges_of_a_cell<dim>()) {
    std::unordered_map<std::size_t, int> number;
    for (const Cell& cell : cells) {
      auto& own = edges_.emplace_back();
      for (int e = 0; e < kPerCell; ++e) {
        const auto [from, to] = ends(cell, e);
        const std::size_t key =
            (static_cast<std::size_t>(std::min(from, to)) << 32) |
            std::max(from, to);
        own[at(e)] = number.try_emplace(key, static_cast<int>(number.size()))
                         .first->second;
      }
    }
    tail_.resize(number.size());
    users_.resize(number.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      for (int e = 0; e < kPerCell; ++e) {
        users_[at(edges_[c][at(e)])].push_back({c, e});
      }
    }
  }

  /// Whether all cells run along their edges the same way.
  bool agree() const {
    std::vector<std::optional<unsigned>> tail(tail_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (int e = 0; e < kPerCell; ++e) {
        const unsigned from = ends(cells_[c], e).first;
        auto& of_edge = tail[at(edges_[c][at(e)])];
        if (!of_edge) of_edge = from;
        if (*of_edge != from) return false;
      }
    }
    return true;
  }

  /// Gives all edges a direction. @return whether they can have one.
  bool direct() {
    // The edges at corner 0, y first: numbers follow from this order.
    constexpr std::array<int, 3> kOrder = {1, 0, 2};
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (int k = 0; k < dim; ++k) {
        if (!direct_from(c, kOrder[static_cast<std::size_t>(k)])) return false;
      }
    }
    return true;
  }

  /// The corner of a cell that all its edges lead away from.
  unsigned origin(std::size_t c) const {
    for (unsigned corner = 0; corner < (1U << dim); ++corner) {
      int leaving = 0;
      for (int e = 0; e < kPerCell; ++e) {
        leaving += tail_[at(edges_[c][at(e)])] == cells_[c][corner] ? 1 : 0;
      }
      if (leaving == dim) return corner;
    }
    return 0;
  }

 private:
  static std::size_t at(int edge) { return static_cast<std::size_t>(edge); }

  std::pair<unsigned, unsigned> ends(const Cell& cell, int e) const {
    const LocalEdge& edge = local_[at(e)];
    return {cell[edge.corner], cell[edge.corner | (1U << edge.direction)]};
  }

  /// From the edge at corner 0 of a cell over all that are parallel to it.
  bool direct_from(std::size_t c, int direction) {
    const auto first = std::ranges::find_if(local_, [&](const LocalEdge& edge) {
      return edge.corner == 0 && edge.direction == direction;
    });
    const auto local = static_cast<int>(first - local_.begin());
    const auto [from, to] = ends(cells_[c], local);
    const int start = edges_[c][at(local)];
    if (tail_[at(start)]) return true;
    tail_[at(start)] = dim == 2 ? to : from;
    std::vector<int> open{start};
    while (!open.empty()) {
      const int edge = open.back();
      open.pop_back();
      for (const auto& [cell, e] : users_[at(edge)]) {
        if (!spread(cell, e, open)) return false;
      }
    }
    return true;
  }

  /// To the edges of a cell that face edge e.
  bool spread(std::size_t c, int e, std::vector<int>& open) {
    const bool is_forward =
        tail_[at(edges_[c][at(e)])] == ends(cells_[c], e).first;
    for (int other = 0; other < kPerCell; ++other) {
      if (local_[at(other)].direction != local_[at(e)].direction) continue;
      const auto [from, to] = ends(cells_[c], other);
      const unsigned wanted = is_forward ? from : to;
      auto& tail = tail_[at(edges_[c][at(other)])];
      if (tail && *tail != wanted) return false;
      if (tail) continue;
      tail = wanted;
      open.push_back(edges_[c][at(other)]);
    }
    return true;
  }

  const std::vector<Cell>& cells_;
  std::vector<LocalEdge> local_;
  std::vector<std::array<int, kPerCell>> edges_;                 ///< per cell
  std::vector<std::vector<std::pair<std::size_t, int>>> users_;  ///< per edge
  std::vector<std::optional<unsigned>> tail_;  ///< vertex it leads away from
};

/// The cell with a corner as its first: directions turned back that lead there,
/// and for an odd number of them in reverse order, so that it stays
/// right-handed.
template <int dim>
Cell turned(const Cell& cell, unsigned origin) {
  const bool is_odd = std::popcount(origin) % 2 != 0;
  Cell result(cell.size());
  for (unsigned corner = 0; corner < cell.size(); ++corner) {
    unsigned from = 0;
    for (int d = 0; d < dim; ++d) {
      const int old = is_odd ? dim - 1 - d : d;
      from |= ((corner >> d) & 1U) << old;
    }
    result[corner] = cell[from ^ origin];
  }
  return result;
}

}  // namespace

template <int dim>
void orient_cells(std::vector<Cell>& cells) {
  Edges<dim> edges(cells);
  if (edges.agree() || !edges.direct()) return;
  std::vector<Cell> result;
  result.reserve(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    result.push_back(turned<dim>(cells[c], edges.origin(c)));
  }
  cells = std::move(result);
}

template void orient_cells<2>(std::vector<Cell>&);
template void orient_cells<3>(std::vector<Cell>&);

}  // namespace clevis::mesh
