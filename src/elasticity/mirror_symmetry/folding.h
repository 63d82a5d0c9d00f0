#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/direct/dissection.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/mirror_symmetry/mirror.h"

namespace clevis::elasticity {

/// A symmetric part on one side of its mirrors.
///
/// Displacements split into parity classes; class c is even about mirror k if
/// bit k of c is 0: u(Rx) = R u(x), else odd: u(Rx) = −R u(x). Stiffness and
/// classes commute, so each class is a problem of its own on the folded part:
/// K of the folded cells, loads summed over the images, and on the planes
/// those components zero that change their sign.
template <int dim>
struct Folding {
  /// Cells on the low side of all mirrors, exactly on the planes where they
  /// end there; nodes in the order of their elimination.
  Discretization<dim> part;
  std::vector<Mirror> mirrors;  ///< none: nothing is folded
  std::vector<int> node;        ///< of the whole part → of the folded
  /// Per node of the whole part, bit k: it stands behind mirror k.
  std::vector<unsigned> behind;
  /// Per node of the folded part, bit k: it stands on mirror k.
  std::vector<unsigned> on_plane;
  Dissection dissection;  ///< of `part`

  unsigned classes() const { return 1U << mirrors.size(); }
  /// Operations [1] and memory [bytes] of one Cholesky factor of the folded
  /// part.
  double factor_flops() const { return dissection.flops * dim * dim * dim; }
  double factor_bytes() const { return 8.0 * dissection.entries * dim * dim; }
};

/// @param positions  of the nodes [m].
template <int dim>
Folding<dim> fold(const Discretization<dim>& whole,
                  const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions,
                  std::vector<Mirror> mirrors);

/// Loads of a class on the folded part, in the units of `whole`: dofs of `part`
/// × columns.
template <int dim>
Eigen::MatrixXd loads_of_class(const Folding<dim>& folding, unsigned parity,
                               const Eigen::MatrixXd& whole);

/// Adds the displacements of a class to those of the whole part, dofs ×
/// columns, in the units of `folded`.
template <int dim>
void add_unfolded(const Folding<dim>& folding, unsigned parity,
                  const Eigen::MatrixXd& folded, Eigen::MatrixXd& whole);

/// Components on the planes that a class holds at zero, sorted.
template <int dim>
std::vector<int> held_on_planes(const Folding<dim>& folding, unsigned parity);

/// Which of `rigid_modes` about a centre on all mirrors belong to a class.
template <int dim>
std::vector<int> rigid_modes_of(const Folding<dim>& folding, unsigned parity);

}  // namespace clevis::elasticity
