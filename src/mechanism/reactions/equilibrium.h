#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "mechanism/compliance/reaction_sharing.h"
#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/motion.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

/// Mass, inertia and loads of the bodies of a mechanism, for the equilibrium
///   Jᵀ λ = M a + gyroscopic terms − Q
/// of every instant. λ of the joints' rows are the reactions, λ of the
/// drives' rows their efforts.
class Equilibrium {
 public:
  Equilibrium(const MechanismDefinition& definition, const SolvingFrame& frame,
              const ConstraintSystem& system);

  struct Solution {
    std::vector<JointReaction> joints;     ///< expressed in P
    std::vector<double> efforts;           ///< by drive
    std::vector<CouplingState> couplings;  ///< expressed in P
  };
  /// @param twists, accelerations  by slot, of M, in P [m/s], [rad/s]; [m/s²],
  ///   [rad/s²].
  /// @param applied  further wrenches about M by slot [N], [N m], or none.
  /// @param elements  what makes these up, for the elastic links that it
  ///   strains; or none.
  Solution solve(const Configuration& x, const std::vector<PlacedJoint>& placed,
                 const numerics::JacobianFactor& factor,
                 const std::vector<Twist>& twists,
                 const std::vector<SpatialAcceleration>& accelerations,
                 std::span<const SpatialForce> applied = {},
                 std::span<const ElementState> elements = {}) const;

  /// The same with joints that give way, of the system's own motions only.
  /// Nothing if no balance was found. @param held  columns of unknowns [m], see
  /// compliant_balance().
  std::optional<Solution> solve_compliant(
      const Configuration& x, const std::vector<PlacedJoint>& placed,
      const std::vector<Twist>& twists,
      const std::vector<SpatialAcceleration>& accelerations,
      std::span<const SpatialForce> applied = {},
      const Eigen::MatrixXd& held = {}) const;

 private:
  /// The system's own reactions, and where loads act across the plane those of
  /// them.
  Solution reactions(const std::vector<PlacedJoint>& placed,
                     const numerics::JacobianFactor& factor,
                     const std::vector<SpatialForce>& required,
                     const std::vector<Eigen::VectorXd>& strains) const;
  /// Finds the force of teeth whose effort is unique and takes what it does
  /// beyond that effort from what is required; it does no work.
  /// @return whether there are any.
  bool resolve_teeth(const Configuration& x,
                     const std::vector<PlacedJoint>& placed,
                     std::vector<CouplingState>& couplings,
                     std::vector<SpatialForce>& required) const;
  Solution empty_solution(const std::vector<PlacedJoint>& placed) const;
  void add_efforts(Solution& solution, const ConstraintSystem& rows,
                   const Eigen::VectorXd& lambda) const;
  std::vector<SpatialForce> required_wrenches(
      const Configuration& x, const std::vector<Twist>& twists,
      const std::vector<SpatialAcceleration>& accelerations,
      std::span<const SpatialForce> applied) const;
  void balance_nearly_dependent(const std::vector<PlacedJoint>& placed,
                                const Eigen::VectorXd& f,
                                const std::vector<Eigen::VectorXd>& strains,
                                SharedReactions& shared) const;
  void add(Solution& solution, const std::vector<PlacedJoint>& placed,
           const ConstraintSystem& rows, const Eigen::VectorXd& lambda) const;
  /// Whether anything loads the parts across the plane of motion: loads with
  /// such components, or joints beside one another along its normal.
  bool acts_across_plane(const std::vector<PlacedJoint>& placed,
                         const std::vector<SpatialForce>& required) const;
  void solve_out_of_plane(Solution& solution,
                          const std::vector<PlacedJoint>& placed,
                          std::vector<SpatialForce> required,
                          const std::vector<Eigen::VectorXd>& strains) const;
  /// All reactions together, where the plane alone leaves some open and loads
  /// or joints lie beside it: how far these give way across the plane then
  /// shares those in it. Nothing if the joints do not hold the loads.
  std::optional<Solution> solve_in_space(
      const std::vector<PlacedJoint>& placed,
      const std::vector<SpatialForce>& required,
      const std::vector<Eigen::VectorXd>& strains) const;
  /// Of each elastic link, as of strain_beside_joints() [√J].
  std::vector<Eigen::VectorXd> link_strains(
      const Configuration& x, const std::vector<Twist>& twists,
      std::span<const ElementState> elements) const;
  static void mark(Solution& solution, const SharedReactions& shared);

  struct Inertia {
    double mass{};
    Eigen::Vector3d p_MCm;
    Eigen::Matrix3d about_cm;
  };
  const SolvingFrame& frame_;
  const ConstraintSystem& system_;
  ConstraintSystem out_of_plane_, in_space_;
  std::vector<Inertia> inertia_;  ///< by slot
  Eigen::Vector3d gravity_;
};

}  // namespace clevis::mechanism
