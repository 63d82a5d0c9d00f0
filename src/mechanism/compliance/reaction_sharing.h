#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

/// Reactions of all joints of one system, where equilibrium leaves some open.
///
/// Of all λ with Jᵀλ = f the one of least complementary energy ½ wᵀ C w is
/// taken, w = E λ the forces and moments of the joints in their frames J and C
/// their compliances: that of links on joints that give way a little. Elastic
/// links add their strain energy, with what strains them beside their joints.
/// It depends neither on units nor on the order of the joints.
struct SharedReactions {
  Eigen::VectorXd lambda;  ///< scaled, by row [N]

  /// By component: six per joint (force [N], moment [N m] in frame J on a),
  /// then one per coupling (scaled).
  Eigen::VectorXd components;
  std::vector<bool> unique;  ///< equilibrium alone determines it
  /// Largest change of each component, to first order, if each compliance is
  /// doubled or halved.
  Eigen::VectorXd spread;
};

/// @param factor  of the Jacobian of `system` at `placed`.
/// @param f       right-hand side, of ConstraintSystem::wrench_vector [N].
/// @param strains  of each elastic link beside its joints, as of
///   strain_beside_joints() [√J].
/// Source: docs/theory.md, "Reactions".
SharedReactions share_reactions(const SolvingFrame& frame,
                                const ConstraintSystem& system,
                                const std::vector<PlacedJoint>& placed,
                                const numerics::JacobianFactor& factor,
                                const Eigen::VectorXd& f,
                                const std::vector<Eigen::VectorXd>& strains);

}  // namespace clevis::mechanism
