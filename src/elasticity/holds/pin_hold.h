#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/holds/mean_motions.h"
#include "loads/holds/holding_groups.h"

namespace clevis::elasticity {

/// A way in which pins hold a free part as a whole (PinHold).
struct HoldingSeats {
  loads::HoldingGroups groups;
  /// Of the slides among them, what is touched; nothing: all of their groups.
  std::optional<TouchedSeats> touched = {};
  /// What holds in the place of the groups, which hold what is left; empty: the
  /// groups alone.
  std::vector<loads::GroupHold> held = {};
  std::vector<loads::GroupHold> sprung = {};  ///< of loads::PartHold
  bool with_all = false;  ///< of `held` also what is beyond rigid motions
  std::vector<Eigen::Index> instants = {};  ///< rising; empty: all

  bool is_at(Eigen::Index instant) const {
    return instants.empty() || std::ranges::binary_search(instants, instant);
  }
};

/// How pins hold a free part as a whole, and no more: the mean displacement of
/// the first group's surface, that of the second across the line between both,
/// and (dim = 3) the first's mean rotation about that line. With one group, or
/// two about one centre, all of its mean rotation; with none, all nodes'. Of
/// what is held otherwise (HoldingSeats::held) as many combinations as the
/// part's rigid motions feel, then those in which its springs take up least
/// energy. As many conditions as there are rigid motions, so
/// that loads in balance leave them without reaction; what is held beyond them
/// strains the part and is told apart (beyond()).
template <int dim>
class PinHold {
 public:
  /// @param motions  of the part; outlive the object.
  /// @param hold  groups without faces, as the sides of a layer over a plane
  ///   mesh, do not count.
  /// @param part_name  for messages.
  /// @throws Error M003.
  PinHold(MeanMotions<dim>& motions, const HoldingSeats& hold,
          const std::string& part_name = "");

  /// Of MeanMotions::rigid(), motions × columns: what of displacements u (dofs
  /// × columns [m]) breaks the conditions.
  Eigen::MatrixXd broken(const Eigen::MatrixXd& u) const;
  /// P u = u less rigid motions broken(u).
  Eigen::MatrixXd project(const Eigen::MatrixXd& u) const;
  /// Pᵀ f: forces with the conditions' reactions, in balance, dofs × columns
  /// [N].
  Eigen::MatrixXd balance(const Eigen::MatrixXd& f) const;
  /// Forces on the nodes that reactions beyond rigid motions make, in balance
  /// by the others, dofs × columns [N]; none, unless all are to hold.
  Eigen::MatrixXd beyond() const;

 private:
  const Eigen::MatrixXd& rigid_;
  NodeFunctionals<dim> conditions_;  ///< of unit effect on rigid motions
  NodeFunctionals<dim> all_;  ///< of all that is held, where all are to hold
};

}  // namespace clevis::elasticity
