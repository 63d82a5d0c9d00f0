#pragma once

#include <vector>

namespace clevis::mesh {

/// A corner, edge or face of the unit square or cube, or its inside.
struct CellPart {
  /// Bit d is ξ_d, in the directions in which the part does not run; 0 in
  /// those in which it does.
  unsigned corner{};
  std::vector<int> along;  ///< directions in which it runs, fastest first
};

/// Corners, edges, faces and the inside of a tensor cell, in the order in which
/// the functions of a Lagrange basis are numbered (that of deal.II's FE_Q).
template <int dim>
const std::vector<CellPart>& cell_parts();

/// The corner of a cell that is this one of a part; bit k of `of_part` is the
/// part's coordinate in its direction k.
unsigned corner_of(const CellPart& part, unsigned of_part);

/// Lexicographic number (ξ_0 fastest) of each function of the Lagrange basis:
/// part after part.
template <int dim>
std::vector<unsigned> lexicographic_numbers(int degree);

}  // namespace clevis::mesh
