#pragma once

#include <cstddef>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/fe/mapping_q_cache.h>

#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// A rank's share of a part's tensor cells as deal.II has them, with the
/// geometry of the discretisation, cell by cell; a lone rank has all.
template <int dim>
class MeshShare {
 public:
  /// @param discretization  the whole part, on every rank.
  MeshShare(const Discretization<dim>& discretization, MPI_Comm ranks);

  const dealii::Triangulation<dim>& triangulation() const {
    return triangulation_;
  }
  const dealii::MappingQCache<dim>& mapping() const { return mapping_; }
  MPI_Comm ranks() const { return ranks_; }

  /// Number of a cell in the discretisation.
  static std::size_t number(
      const typename dealii::Triangulation<dim>::cell_iterator& cell) {
    return cell->id().get_coarse_cell_id();
  }

 private:
  MPI_Comm ranks_;
  dealii::parallel::fullydistributed::Triangulation<dim> triangulation_;
  dealii::MappingQCache<dim> mapping_;
};

}  // namespace clevis::elasticity
