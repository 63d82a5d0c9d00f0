#include "mesh/reading/orient.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "mesh/cells/topology.h"

namespace clevis::mesh {

namespace {

/// Edges that must point the same way, up to a sign: union-find with parity.
class EdgeClasses {
 public:
  explicit EdgeClasses(std::size_t count) : parent_(count), flip_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Root of the class and whether the edge points against the root.
  std::pair<std::size_t, int> find(std::size_t edge) {
    int flip = 0;
    while (parent_[edge] != edge) {  // halving the path on the way
      flip_[edge] ^= flip_[parent_[edge]];
      parent_[edge] = parent_[parent_[edge]];
      flip ^= flip_[edge];
      edge = parent_[edge];
    }
    return {edge, flip};
  }

  /// False if the two were joined the other way round before.
  bool join(std::size_t a, std::size_t b, int opposite) {
    const auto [root_a, flip_a] = find(a);
    const auto [root_b, flip_b] = find(b);
    if (root_a == root_b) return (flip_a ^ flip_b) == opposite;
    const auto [low, high] = std::minmax(root_a, root_b);
    parent_[high] = low;
    flip_[high] = flip_a ^ flip_b ^ opposite;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<int> flip_;
};

/// Numbers the edges; an edge points from its lower to its higher vertex.
class EdgeNumbers {
 public:
  explicit EdgeNumbers(const PartMesh<3>& mesh) {
    for (const auto& cell : mesh.cells) {
      for (const HexEdge& edge : hex_edges()) {
        const auto key = std::minmax(cell[std::size_t(edge.from)],
                                     cell[std::size_t(edge.to)]);
        number_.try_emplace(key, number_.size());
      }
    }
  }
  std::size_t size() const { return number_.size(); }

  /// Number, and whether `edge` of the cell points against it.
  std::pair<std::size_t, int> find(const std::vector<unsigned>& cell,
                                   const HexEdge& edge) const {
    const unsigned from = cell[std::size_t(edge.from)];
    const unsigned to = cell[std::size_t(edge.to)];
    return {number_.at(std::minmax(from, to)), from > to};
  }

 private:
  std::map<std::pair<unsigned, unsigned>, std::size_t> number_;
};

/// New cell axes: new axis d runs along old axis `axis[d]`, backwards if
/// `reverse[d]`.
struct Turn {
  std::array<int, 3> axis{0, 1, 2};
  std::array<bool, 3> reverse{};
};

void apply(PartMesh<3>& mesh, std::size_t cell, const Turn& turn) {
  const auto reordered = [&](int n, const auto& move) {
    std::array<int, 3> i{};
    for (i[2] = 0; i[2] < n; ++i[2]) {
      for (i[1] = 0; i[1] < n; ++i[1]) {
        for (i[0] = 0; i[0] < n; ++i[0]) {
          std::array<int, 3> old{};
          for (std::size_t d = 0; d < 3; ++d) {
            old[std::size_t(turn.axis[d])] =
                turn.reverse[d] ? n - 1 - i[d] : i[d];
          }
          move(i[0] + n * (i[1] + n * i[2]),
               old[0] + n * (old[1] + n * old[2]));
        }
      }
    }
  };
  const auto old_vertices = mesh.cells[cell];
  reordered(2, [&](int to, int from) {
    mesh.cells[cell][std::size_t(to)] = old_vertices[std::size_t(from)];
  });
  const Eigen::Matrix3Xd old_points = mesh.cell_points[cell];
  reordered(mesh.degree + 1, [&](int to, int from) {
    mesh.cell_points[cell].col(to) = old_points.col(from);
  });
}

}  // namespace

void orient_consistently(PartMesh<3>& mesh) {
  const EdgeNumbers numbers(mesh);
  EdgeClasses classes(numbers.size());
  for (const auto& cell : mesh.cells) {
    for (std::size_t e = 0; e < 12; ++e) {
      if (e % 4 == 0) continue;  // four edges per axis; join with the first
      const auto [first, first_flip] =
          numbers.find(cell, hex_edges()[e - e % 4]);
      const auto [edge, flip] = numbers.find(cell, hex_edges()[e]);
      if (!classes.join(first, edge, first_flip ^ flip)) return;
    }
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    Turn turn;
    int reversed = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto [edge, flip] = numbers.find(mesh.cells[c], hex_edges()[4 * d]);
      turn.reverse[d] = (flip ^ classes.find(edge).second) != 0;
      reversed += turn.reverse[d];
    }
    if (reversed == 0) continue;
    if (reversed % 2 == 1) {  // keep right-handed cells right-handed
      std::swap(turn.axis[0], turn.axis[1]);
      std::swap(turn.reverse[0], turn.reverse[1]);
    }
    apply(mesh, c, turn);
  }
}

}  // namespace clevis::mesh
