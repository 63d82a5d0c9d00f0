#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// Seats of a part, and what counterparts touch of them at an instant.
struct TouchedSeats {
  std::vector<loads::Seat> seats;
  std::vector<loads::ContactZone> zones;  ///< one per seat
};

/// Linear functionals of displacements at some nodes.
struct NodeFunctionals {
  std::vector<Eigen::Index> nodes;  ///< one may stand there twice
  Eigen::MatrixXd rows;             ///< functionals × 3 nodes

  /// Of displacements u, dofs × columns [m].
  Eigen::MatrixXd of(const Eigen::MatrixXd& u) const;
  /// Adds amounts of theirs [N], functionals × columns, to forces, dofs ×
  /// columns [N].
  void add(const Eigen::MatrixXd& amounts, Eigen::MatrixXd& forces) const;
};

/// Of functionals as columns over all degrees of freedom, weights.
NodeFunctionals nodes_of(const Eigen::MatrixXd& columns);

/// How pins hold a free part as a whole, and no more: the mean displacement of
/// the first group's surface, that of the second across the line between both,
/// and the first's mean rotation about that line. With one group, or two about
/// one centre, all of its mean rotation; with none, all nodes'. Six conditions
/// on rigid motions, so that loads in balance leave them without reaction.
class PinHold {
 public:
  /// @param groups  two at the most; those without faces, as the sides of a
  ///   layer over a plane mesh, do not count.
  /// @param touched  of the groups of slides, what counterparts touch of them;
  ///   null: all of each group holds.
  PinHold(const Discretization<3>& discretization,
          const std::vector<std::string>& groups,
          const TouchedSeats* touched = nullptr);

  /// Rigid motions about the nodes' mean, the same for every hold: three
  /// translations, three rotations, dofs × 6.
  const Eigen::MatrixXd& rigid() const { return rigid_; }
  /// Of rigid(), 6 × columns: what of displacements u (dofs × columns [m])
  /// breaks the conditions.
  Eigen::MatrixXd broken(const Eigen::MatrixXd& u) const;
  /// P u = u less rigid() broken(u).
  Eigen::MatrixXd project(const Eigen::MatrixXd& u) const;
  /// Pᵀ f: forces with the conditions' reactions, in balance, dofs × columns
  /// [N].
  Eigen::MatrixXd balance(const Eigen::MatrixXd& f) const;

 private:
  Eigen::MatrixXd rigid_;       ///< rigid motions, dofs × 6
  NodeFunctionals conditions_;  ///< six, of unit effect on rigid_
};

}  // namespace clevis::elasticity
