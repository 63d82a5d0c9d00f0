#pragma once

#include <array>
#include <vector>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "mechanism/force_laws/friction_laws.h"
#include "numerics/curves/linear_table.h"

namespace clevis::mechanism {

/// Mode of friction that is left out: for a moment, or at rest while joints and
/// drives alone carry its line.
inline constexpr int kLetGo = 3;

/// A force element placed in a mechanism, and what it does in a state.
///
/// Laws with kinks are followed piece by piece: a mode says which piece
/// holds. Friction: 0 sticks, ±1 slips in that sense, ±2 gives its most against
/// that sense while other friction still holds the line, 3 kLetGo; its
/// second mode tells whether it is in Stribeck's zone, as that of a contact
/// does of its sliding. Contacts and
/// stops: 0 open, 1 pressing, 2 deep but without force; a stop has one such
/// mode per end. Tables over positions: the piece, see piece_effort(); what
/// acts on one sense of motion has as second mode whether its line moves so.
struct ActingElement {
  const ForceElement* definition{};
  JointModel line;  ///< J: its ends; a contact's plane (a) and centre (b)
  JointRow row;     ///< what a line measures
  Eigen::Matrix3d R_PW = Eigen::Matrix3d::Identity();
  int internal = -1;  ///< index of its first internal state
  int internal_count = 0;
  std::array<int, 2> modes{};
  /// As of accept() or anchor(): from there turns are counted.
  double q_start{}, rate_start{}, t_start{};
  /// Speed below which speeds tell nothing: bristles turn late by that, and no
  /// law is regularised by less.
  double slack{};
  /// Speed beyond which a line that rests without a row of its own slips.
  double leaving{};
  /// Friction at the state of hold_tangent(); acts instead of the law.
  struct Tangent {
    bool holds = false;
    double rate{}, bristle{};
    FrictionEffort line;
    Eigen::Vector3d sliding = Eigen::Vector3d::Zero();
    SlidingFriction contact;
  };
  Tangent tangent{};

  // as of evaluate()
  PlacedJoint placed;
  PlacedJoint::Levers levers;  ///< of a line
  double q{}, rate{};          ///< of a line; a contact's depth; [m] or [rad]
  double effort{};             ///< on b, > 0 pushes apart; normal force
  double friction{};           ///< of a contact [N]
  Eigen::Vector3d sliding = Eigen::Vector3d::Zero();  ///< of a contact [m/s]
  /// What friction is proportional to: 1, or the joint's force if it follows
  /// that; 0 until that is known [N].
  double load = 1.0;
  double per_load{}, own_effort{};  ///< effort = load × per_load + own_effort
  GasInternals internal_rates{};    ///< room enough for any law
  GasChamberStates gas{};
  GasInterface interface {};  ///< of gas that communicates in steps
  MotorState motor{};
  std::array<double, 2> depth{}, depth_rate{};  ///< by end, or of a contact
  std::array<double, 2> unbounded{};  ///< contact_effort() whatever the mode
  Twist on_a{}, on_b{};               ///< force and moment about M
  double power{};                     ///< [W]
};

/// @param definition  outlives the result. @param internal_states  how many
///   there are so far; counts those of this element.
ActingElement acting_element(const ForceElement& definition,
                             const SolvingFrame& frame, int& internal_states);

/// Computes what is "as of evaluate()". Sticking friction has no effort of
/// its own.
/// @param twists  by slot. @param internal  all internal states.
/// @param side  of a table's step at t.
void evaluate(ActingElement& e, double t, const Configuration& x,
              const std::vector<Twist>& twists, const double* internal,
              numerics::StepSide side);

/// Sets its internal states to those of the start.
/// @throws Error K009.
void start_internal(ActingElement& e, const Configuration& x, double* internal);

/// When gas and mechanism communicate next [s]; never if they are integrated
/// together.
double next_communication(const ActingElement& e);
/// They do, as of the last evaluate().
void communicate(ActingElement& e, double t);

/// The state of the last evaluate() is part of the motion: angles count
/// their turns from there.
void accept(ActingElement& e, double t);

/// What it does to its bodies, as of evaluate(); a contact acts where it
/// touches, all others at their ends.
std::array<ElementAction, 2> actions(const ActingElement& e);

/// Its friction acts by the tangent at the state of the last evaluate(), until
/// tangent.holds is false again.
void hold_tangent(ActingElement& e, const double* internal);

/// Lets a line act with an effort.
void act_along(ActingElement& e, double effort);

/// Inertia that turns with a line's coordinate [kg m²]: that of a rotor.
double line_inertia(const ActingElement& e);

}  // namespace clevis::mechanism
