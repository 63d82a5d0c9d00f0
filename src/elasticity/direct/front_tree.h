#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elasticity/direct/dissection.h"

namespace clevis::elasticity {

/// Unknowns that are eliminated together, and the later ones they are coupled
/// to; by their place in the order of elimination.
struct Front {
  int begin{}, end{};
  std::vector<int> border;  ///< ascending
  int children{};           ///< fronts whose borders this one takes over

  int own() const { return end - begin; }
  int later() const { return static_cast<int>(border.size()); }
  int size() const { return own() + later(); }
  std::size_t panel_entries() const {
    return static_cast<std::size_t>(own()) * static_cast<std::size_t>(size());
  }
  std::size_t border_entries() const {
    return static_cast<std::size_t>(later()) *
           static_cast<std::size_t>(later());
  }
  double flops() const {
    const double n = own(), m = later();
    return n * (n * n / 3.0 + m * (n + m));
  }
};

/// The fronts of a matrix whose nodes have several unknowns each.
struct FrontTree {
  std::vector<Front> fronts;  ///< each behind its children
  std::vector<int> place;     ///< per equation: in the order of elimination

  std::size_t factor_entries() const;
};

/// Entries of the borders' matrices that stand at the same time, at most, while
/// these fronts, all below the last of them, are eliminated.
std::size_t stack_entries(std::span<const Front> fronts);

/// Per front the first one below it; itself where there is none.
std::vector<std::size_t> first_below(const std::vector<Front>& fronts);

/// @param dissection  of all cells that the matrix is assembled of.
/// @param unknowns    per node; unknown a of node n is number unknowns·n + a.
/// @param equation    per unknown; -1: held.
FrontTree front_tree(const Dissection& dissection, int unknowns,
                     const std::vector<int>& equation);

}  // namespace clevis::elasticity
