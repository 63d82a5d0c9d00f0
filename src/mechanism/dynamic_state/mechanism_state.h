#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/forces/applied_loads.h"
#include "mechanism/joints/configuration.h"

namespace clevis::mechanism {

/// A state of a motion by forces, spread over bodies, joints and loads. Bodies
/// are referred to their centres of mass M.
struct MechanismState {
  /// Positions by slot, turns by joint [m], [rad]. Planar: without quaternions.
  Configuration x;
  std::vector<Twist> twists;        ///< by slot [m/s], [rad/s]
  std::vector<PlacedJoint> placed;  ///< by joint
  /// Of the unknowns of ConstraintSystem, then of rotors, which turn as their
  /// joints do: 0 [m/s].
  Eigen::VectorXd speeds;
  LoadState loads;  ///< where they have been evaluated
};

}  // namespace clevis::mechanism
