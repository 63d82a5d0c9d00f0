#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/definition.h"
#include "mechanism/dynamic_state/drive_schedule.h"
#include "mechanism/dynamic_state/mechanism_state.h"
#include "mechanism/dynamic_state/state_layout.h"
#include "mechanism/dynamic_state/turn_counter.h"
#include "mechanism/equations_of_motion/following_friction.h"
#include "mechanism/equations_of_motion/motion_constraints.h"
#include "mechanism/forces/applied_loads.h"
#include "mechanism/mass_matrix/body_inertias.h"

namespace clevis::mechanism {

/// M a = Q + Jᵀ λ, J a = γ in a state: unknowns of bodies and rotors by
/// column, rows of MotionConstraints.
struct MotionSolution {
  Eigen::VectorXd forces;             ///< Q [N], moments over the length
  Eigen::VectorXd row_accelerations;  ///< γ [m/s²]
  Eigen::VectorXd accelerations;      ///< a [m/s²]
  Eigen::VectorXd multipliers;        ///< λ, scaled as the rows are [N]
  double following_power{};  ///< of friction that follows reactions [W]
};

/// Equations of motion of a mechanism with free coordinates, in the states y
/// of StateLayout. Drives are constraints that move. Times [s].
///
/// A reference that a function returns holds until the next call of place(),
/// evaluate_forces(), factor() or solve().
class EquationsOfMotion {
 public:
  /// @param definition, frame  outlive this; frame_at_centres().
  EquationsOfMotion(const MechanismDefinition& definition,
                    const SolvingFrame& frame);

  /// State y of bodies at rest, from which turns count. @throws Error K009.
  Eigen::VectorXd start(const Configuration& x);
  /// Drives and forces follow from now on, at t itself too, what their laws say
  /// behind a bend at t.
  void enter_piece(double t);
  /// The state y is part of the motion: angles that count turns go on from
  /// there. @pre it, or one close to it, is state(), with its loads.
  void accept(double t, const Eigen::VectorXd& y);

  /// Bodies and joints of a state.
  const MechanismState& place(double t, const Eigen::VectorXd& y);
  /// The same, and the force elements.
  const MechanismState& evaluate_forces(double t, const Eigen::VectorXd& y);
  /// The same with all loads, Q, constraints, factored, and the targets of
  /// drives.
  const MechanismState& factor(double t, const Eigen::VectorXd& y);
  /// Places a state; from now on friction acts by its tangents there.
  void hold_tangents(double t, const Eigen::VectorXd& y);
  /// Accelerations, multipliers, and efforts of what sticks. Not finite where
  /// jams().
  const MotionSolution& solve(double t, const Eigen::VectorXd& y);
  /// Accelerations that a force on the unknowns [N] adds to those of the last
  /// solve(), and its multipliers; the rest is not filled.
  const MotionSolution& respond(const Eigen::VectorXd& force);

  /// Friction that follows a reaction and jams, why the last solve() failed.
  std::optional<std::size_t> self_locking() const {
    return following_.self_locking();
  }
  /// Whether nothing but joints, drives and rotors holds the bodies now.
  bool has_joints_alone() const;
  /// Of bodies and rotors [J].
  double kinetic_energy(const Eigen::VectorXd& y);

  const StateLayout& layout() const { return layout_; }
  const ConstraintSystem& system() const { return system_; }
  const BodyInertias& inertias() const { return inertias_; }
  const DriveSchedule& drives() const { return drives_; }
  const DriveTargets& targets() const { return targets_; }
  TurnCounter& turns() { return turns_; }
  MotionConstraints& constraints() { return constraints_; }
  AppliedLoads& loads() { return loads_; }
  ForceModel& forces() { return loads_.forces(); }
  const MechanismState& state() const { return state_; }
  const MotionSolution& solution() const { return solution_; }

 private:
  void put_row_accelerations();

  ConstraintSystem system_;
  AppliedLoads loads_;
  StateLayout layout_;
  BodyInertias inertias_;
  MotionConstraints constraints_;
  FollowingFriction following_;
  DriveSchedule drives_;
  TurnCounter turns_;
  MechanismState state_;
  DriveTargets targets_;
  MotionSolution solution_, response_;
  Eigen::VectorXd at_rest_;  ///< γ of respond()
};

}  // namespace clevis::mechanism
