#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/element_base/element_state.h"
#include "mechanism/joints/joint_model.h"

namespace clevis::mechanism {

/// Response of a force element in one state of a motion: place, effort, and its
/// action on bodies a and b.
struct ElementResponse {
  /// Without effort, at no place.
  ElementResponse();

  /// Lets a line act with an effort [N], [N m].
  void act_along(double new_effort);
  /// The same, which changes its power too.
  void give_effort(double new_effort);

  PlacedJoint placed;
  PlacedJoint::Levers levers;  ///< of a line
  double q{}, rate{};          ///< of a line; a contact's depth; [m] or [rad]
  double effort{};             ///< on b, > 0 pushes apart; normal force
  double friction{};           ///< of a contact [N]
  /// Load that friction is proportional to: 1, or the joint's force if it
  /// follows that; 0 until that is known [N].
  double load = 1.0;
  double per_load{}, own_effort{};  ///< effort = load × per_load + own_effort
  std::vector<double> internal_rates;           ///< one per internal state
  std::array<double, 2> depth{}, depth_rate{};  ///< by end, or of a contact
  /// Effort of a pressing end whatever its mode, without the bound at 0.
  std::array<double, 2> unbounded{};
  Eigen::Vector3d sliding = Eigen::Vector3d::Zero();  ///< of a contact [m/s]
  SpatialForce on_a{}, on_b{};  ///< force and moment about M
  double power{};               ///< [W]
  // what its kind alone has to say, see ElementState
  std::vector<double> channels;
  std::vector<GasChamberState> chambers;
  std::optional<GasInterface> interface;
  std::optional<MotorState> motor;
};

/// Changes of a line's effort by small motions: −stiffness q − damping q'.
struct LineTangent {
  double stiffness{};  ///< [N/m] or [N m/rad]
  double damping{};    ///< [N s/m] or [N m s/rad]
  /// Both one behind the other: what yields slowly meets no effort.
  bool relaxes = false;

  bool is_zero() const { return stiffness == 0.0 && damping == 0.0; }
};

/// Changes of a force element's actions by small motions of its bodies:
/// efforts −K q − C q' along directions, q the motions along these. What
/// turning makes of a force that stays the same is not among them.
struct ElementSpring {
  /// Of efforts of 1, in P; their products with twists of a and b are q.
  std::vector<PlacedJoint::Levers> directions;
  Eigen::MatrixXd stiffness;  ///< K, symmetric [N/m], [N], [N m]
  Eigen::MatrixXd damping;    ///< C, the same times [s]
  bool relaxes = false;       ///< of LineTangent; of one direction
};

}  // namespace clevis::mechanism
