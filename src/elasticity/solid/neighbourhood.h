#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"
#include "part/part_definition.h"

namespace clevis::elasticity {

/// Cells and all that share a node with them, ascending.
template <int dim>
std::vector<int> with_neighbours(const Discretization<dim>& discretization,
                                 const std::vector<int>& cells);

/// A field solved with one degree, and what a higher one on the same mesh
/// would be loaded and held by. That may be of some cells alone, if all around
/// the neighbourhood are among them.
template <int dim>
struct EnrichmentProblem {
  const Discretization<dim>& coarse;
  const Eigen::MatrixXd& displacement;  ///< dofs of `coarse` × 1 [m]
  const Discretization<dim>& fine;      ///< same mesh, higher degree
  const Eigen::MatrixXd& load;          ///< dofs of `fine` × 1 [N]
  std::vector<int> held;                ///< dofs of `fine`; empty: a free part
  const part::Material& material;
  /// Cell of `coarse` per cell of `fine`, oriented alike; empty: the same.
  std::vector<int> coarse_cells = {};
  part::Foundations foundations = {};  ///< under faces of `fine`
};

/// The field of higher degree on some cells.
template <int dim>
struct Enriched {
  DisplacementBasis<dim> basis;  ///< one column, one instant
  std::vector<int> cells;        ///< of `coarse`, one per cell of `basis`
};

/// Solves with the higher degree in a neighbourhood of some cells, as that of
/// with_neighbours(), the displacement of the lower degree kept on its border
/// to the rest of the part.
///
/// Its change in these cells is an estimate of the error there: it holds
/// what the cells nearby do not resolve, not what comes from far away; of that
/// larger neighbourhoods tell.
/// @param cells  of `fine`: the neighbourhood, ascending.
/// @throws Error F002 if the neighbourhood is loose, M005.
template <int dim>
Enriched<dim> enrich(const EnrichmentProblem<dim>& problem,
                     const std::vector<int>& cells);

}  // namespace clevis::elasticity
