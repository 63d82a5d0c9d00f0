#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"

namespace clevis::mechanism {

/// Linear maps from scaled multipliers [N] of the rows of a system to joint
/// wrenches (components) and to compliance energy (energy_root).
struct ComplianceMaps {
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
ComplianceMaps compliance_maps(const SolvingFrame& frame,
                               const ConstraintSystem& system,
                               const std::vector<PlacedJoint>& placed);

/// What strains a link beside its joints, as a vector e in the rows of its
/// root: ½ |root w + e|² is its energy under the wrenches w of the joints [√J].
/// @param spin   ω in its L [rad/s].
/// @param loads  force [N] and moment about its point [N m] of each of its
///   loads, in L.
Eigen::VectorXd strain_beside_joints(const ElasticLink& link,
                                     const Eigen::Vector3d& spin,
                                     const Eigen::VectorXd& loads);

/// Components (as of ComplianceMaps) per scaled multiplier of the rows: [1], of
/// moments [m].
Eigen::MatrixXd components_of_rows(const SolvingFrame& frame,
                                   const ConstraintSystem& system,
                                   const std::vector<PlacedJoint>& placed);

/// Compliance of the rows against scaled multipliers: Bᵀ B, zero for drives
/// [m/N].
Eigen::MatrixXd row_compliance(const SolvingFrame& frame,
                               const ConstraintSystem& system,
                               const std::vector<PlacedJoint>& placed);

}  // namespace clevis::mechanism
