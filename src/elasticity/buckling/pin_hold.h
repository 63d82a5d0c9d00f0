#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "loads/history/load_history.h"
#include "loads/holds/holding_groups.h"

namespace clevis::elasticity {

/// Seats of a part, and what counterparts touch of them at an instant.
struct TouchedSeats {
  std::vector<loads::Seat> seats;
  std::vector<loads::ContactZone> zones;  ///< one per seat
};

/// A way in which pins hold a free part as a whole (PinHold).
struct HoldingSeats {
  std::vector<std::string> groups;
  /// Of the slides among them, what is touched; nothing: all of their groups.
  std::optional<TouchedSeats> touched = {};
  /// What holds in the place of the groups, which hold what is left; empty: the
  /// groups alone.
  std::vector<loads::GroupHold> held = {};
  bool with_all = false;  ///< of `held` also what is beyond six conditions
  std::vector<Eigen::Index> instants = {};  ///< rising; empty: all

  bool is_at(Eigen::Index instant) const {
    return instants.empty() || std::ranges::binary_search(instants, instant);
  }
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
/// one centre, all of its mean rotation; with none, all nodes'. Of what is held
/// otherwise (HoldingSeats::held) as many combinations as the part's rigid
/// motions feel, those that feel them most. Six conditions on rigid motions, so
/// that loads in balance leave them without reaction; what is held beyond them
/// strains the part and is told apart (beyond()).
class PinHold {
 public:
  /// @param hold  groups without faces, as the sides of a layer over a plane
  ///   mesh, do not count.
  /// @param part_name  for messages.
  /// @param other  of the same part, whose rigid() it shares; or null.
  /// @throws Error M003.
  PinHold(const Discretization<3>& discretization, const HoldingSeats& hold,
          const std::string& part_name = "", const PinHold* other = nullptr);

  /// Rigid motions about the nodes' mean, the same for every hold: three
  /// translations, three rotations, dofs × 6.
  const Eigen::MatrixXd& rigid() const { return *rigid_; }
  /// Of rigid(), 6 × columns: what of displacements u (dofs × columns [m])
  /// breaks the conditions.
  Eigen::MatrixXd broken(const Eigen::MatrixXd& u) const;
  /// P u = u less rigid() broken(u).
  Eigen::MatrixXd project(const Eigen::MatrixXd& u) const;
  /// Pᵀ f: forces with the conditions' reactions, in balance, dofs × columns
  /// [N].
  Eigen::MatrixXd balance(const Eigen::MatrixXd& f) const;
  /// Forces on the nodes that reactions beyond the six make, in balance by
  /// these, dofs × columns [N]; none, unless all are to hold.
  Eigen::MatrixXd beyond() const;

 private:
  std::shared_ptr<const Eigen::MatrixXd> rigid_;
  NodeFunctionals conditions_;  ///< six, of unit effect on rigid()
  NodeFunctionals all_;         ///< of all that is held, where all are to hold
};

}  // namespace clevis::elasticity
