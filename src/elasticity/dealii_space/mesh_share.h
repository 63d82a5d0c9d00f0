#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/fe/mapping_q_cache.h>

#include "elasticity/dealii_space/engine_part.h"

namespace clevis::elasticity {

/// A cell's nodes in the numbering of the discretisation.
struct ShareCell {
  std::vector<int> nodes;
  std::vector<char> is_held;  ///< of number dim * node + component [0 or 1]
};

/// A rank's share of a part's tensor cells as deal.II has them, with the
/// geometry of the discretisation, cell by cell; a lone rank has all. Only the
/// first rank has seen the whole part.
template <int dim>
class MeshShare {
 public:
  /// @param task  the whole part on the first rank, elsewhere nothing.
  MeshShare(const DealiiTask<dim>* task, const EnginePart& part,
            MPI_Comm ranks);

  const dealii::Triangulation<dim>& triangulation() const {
    return triangulation_;
  }
  const dealii::MappingQCache<dim>& mapping() const { return mapping_; }
  MPI_Comm ranks() const { return ranks_; }
  int degree() const { return degree_; }  ///< of the discretisation

  /// Number of a cell in the discretisation.
  static std::size_t number(
      const typename dealii::Triangulation<dim>::cell_iterator& cell) {
    return cell->id().get_coarse_cell_id();
  }

  /// @pre the cell is the rank's or borders one that is.
  const ShareCell& at(
      const typename dealii::Triangulation<dim>::cell_iterator& cell) const {
    return cells_.at(number(cell));
  }

 private:
  void take_cells(const DealiiTask<dim>* task, const EnginePart& part);

  MPI_Comm ranks_;
  int degree_;
  dealii::parallel::fullydistributed::Triangulation<dim> triangulation_;
  dealii::MappingQCache<dim> mapping_;
  std::unordered_map<std::size_t, ShareCell> cells_;
};

}  // namespace clevis::elasticity
