#pragma once

#include <cstddef>
#include <vector>

#include "elasticity/algebra/matrix_rows.h"
#include "elasticity/direct/front_tree.h"

namespace clevis::elasticity {

/// Eliminates all fronts of a tree into their panels.
/// @param ordered  row i holds the entries of the i-th eliminated unknown with
///   itself and with later ones.
/// @param start    of each front's panel in `factor`.
/// @param threads  at least 1; the panels don't depend on it.
/// @return false if the matrix is not positive definite.
template <typename Real>
bool eliminate_fronts(const MatrixRows& ordered, const FrontTree& tree,
                      const std::vector<std::size_t>& start, int threads,
                      Real* factor);

}  // namespace clevis::elasticity
