#pragma once

#include <vector>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include "elasticity/dealii_space/mesh_share.h"

namespace clevis::elasticity {

/// Displacements of one degree on a share of the mesh, with the components
/// that are held at zero.
template <int dim>
class DegreeSpace {
 public:
  /// @param degree  at most that of the discretisation; of the lower degrees
  ///   held is what does not vanish at a held node.
  DegreeSpace(const MeshShare<dim>& share, int degree);

  const MeshShare<dim>& share() const { return *share_; }
  const dealii::DoFHandler<dim>& handler() const { return handler_; }
  const dealii::AffineConstraints<double>& held() const { return held_; }
  int degree() const { return degree_; }

  /// Scalar functions of a cell, at the nodes of the discretisation's degree:
  /// nodes × functions [1].
  const std::vector<std::vector<double>>& at_nodes() const { return at_nodes_; }

 private:
  const MeshShare<dim>* share_;
  int degree_;
  std::vector<std::vector<double>> at_nodes_;
  dealii::DoFHandler<dim> handler_;
  dealii::AffineConstraints<double> held_;
};

/// Which degree of freedom of the discretisation each one has that a rank owns,
/// in deal.II's order. @pre the space has the discretisation's degree.
template <int dim>
std::vector<int> own_numbering(const DegreeSpace<dim>& space);

}  // namespace clevis::elasticity
