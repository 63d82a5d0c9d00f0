#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace clevis::elasticity {

/// Shortens the border between two sets of cells: cells change sides as long
/// as that makes both share fewer nodes and leaves two fifths to either. The
/// border through an irregular mesh is rough, and a factorisation costs with
/// the cube of its nodes; that of a structured one stays.
/// Source: the moves of positive gain of [FiducciaMattheyses1982].
class Separator {
 public:
  /// @param cell_nodes  of all cells; outlives the object.
  Separator(const std::vector<std::vector<int>>& cell_nodes, std::size_t nodes)
      : cell_nodes_(cell_nodes),
        at_node_{std::vector<int>(nodes), std::vector<int>(nodes)},
        set_(cell_nodes.size()) {}

  /// @param cells  the first `half` are one set, the others the other; so they
  ///   are afterwards.
  /// @param counts  per node: whether it does.
  /// @return size of the first set.
  std::size_t shorten(std::span<std::size_t> cells, std::size_t half,
                      const std::vector<char>& counts);

 private:
  int gain(std::size_t cell, const std::vector<char>& counts) const;
  void move(std::size_t cell);

  const std::vector<std::vector<int>>& cell_nodes_;
  std::array<std::vector<int>, 2> at_node_;  ///< cells of each set at a node
  std::vector<char> set_;                    ///< per cell: 0 or 1
};

}  // namespace clevis::elasticity
