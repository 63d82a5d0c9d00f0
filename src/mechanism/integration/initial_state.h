#pragma once

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Where an integrated motion starts.
struct InitialState {
  Configuration x;             ///< closed, drives at their start
  Eigen::VectorXd velocities;  ///< unknowns of the system
  int freedom{};               ///< of the joints, at general positions
  int rank{};                  ///< of the system's Jacobian there
};

/// Assembles the mechanism with the joints' initial coordinates, near the
/// placement, and finds the velocities: those of `initial_joints` and of the
/// drives exactly, those of `initial_bodies` as near as the joints allow by the
/// kinetic energy of the difference, of other bodies' as from rest: what drives
/// that move at the start do to the rest is an impulse.
/// @param frame      frame_at_centres().
/// @param system     with the drives.
/// @param tolerance  [m].
/// @throws Error K001, K003, K007.
InitialState initial_state(const MechanismDefinition& definition,
                           const SolvingFrame& frame,
                           const ConstraintSystem& system, double tolerance);

}  // namespace clevis::mechanism
