#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"

namespace clevis::mechanism {

/// What the joints carry, and how joints and links give way under it, per
/// scaled multiplier of the rows of a system.
struct GiveWay {
  /// Components per multiplier: six per joint (force, moment in frame J on a,
  /// about J on b), then one per coupling. Drives have none.
  Eigen::MatrixXd components;
  Eigen::VectorXd compliance;  ///< of the components
  /// Complementary energy ½ |B λ|²: rows of the components, weighted, then
  /// those of the links, on which the drives' efforts act as well.
  Eigen::MatrixXd energy_root;
  /// First row of each link in energy_root, and the end.
  std::vector<Eigen::Index> link_rows;
};

/// Source: docs/theory.md, "Reactions".
GiveWay give_way(const SolvingFrame& frame, const ConstraintSystem& system,
                 const std::vector<PlacedJoint>& placed);

/// Components (as of GiveWay) per scaled multiplier of the rows.
Eigen::MatrixXd components_of_rows(const SolvingFrame& frame,
                                   const ConstraintSystem& system,
                                   const std::vector<PlacedJoint>& placed);

/// Compliance of the rows against scaled multipliers: Bᵀ B, zero for drives.
Eigen::MatrixXd row_compliance(const SolvingFrame& frame,
                               const ConstraintSystem& system,
                               const std::vector<PlacedJoint>& placed);

}  // namespace clevis::mechanism
