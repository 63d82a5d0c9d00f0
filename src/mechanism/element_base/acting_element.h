#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mechanism/element_base/element_response.h"
#include "mechanism/element_base/force_line.h"
#include "mechanism/element_base/friction_traits.h"
#include "mechanism/element_base/internal_states.h"
#include "mechanism/element_base/mode_switch.h"
#include "mechanism/element_base/touching_ends.h"
#include "mechanism/joints/configuration.h"
#include "numerics/curves/linear_table.h"

namespace clevis::mechanism {

/// State of a motion in which forces act.
struct ActingState {
  double t{};  ///< [s]
  const Configuration& configuration;
  const std::vector<Twist>& twists;  ///< by slot
  const double* internal{};          ///< states of all elements
  numerics::StepSide side{};         ///< of a table's step at t
};

/// An angle [rad] and its rate [rad/s] at t [s], from which turns are counted.
struct AngleAnchor {
  double q{}, rate{}, t{};
};

/// A line at rest that is about to give way.
struct LineAtRest {
  double t{};     ///< [s]
  double load{};  ///< of its friction, as of ElementResponse::load [1], [N]
  double sway{};  ///< by which it gives way [m] or [rad]
  const ElementState& state;
};

/// A force element placed between two bodies: its response to a state, by its
/// modes.
///
/// Kinds override what they do otherwise than an element without states, modes,
/// friction and ends that press.
class ActingElement : public InternalStates,
                      public ModeSwitch,
                      public FrictionTraits,
                      public TouchingEnds {
 public:
  ActingElement() = default;
  virtual ~ActingElement() = default;
  ActingElement(const ActingElement&) = delete;
  ActingElement& operator=(const ActingElement&) = delete;

  /// Puts its response to a state. Sticking friction has no effort of its own.
  void evaluate(const ActingState& state, ElementResponse& now) const;
  /// The state at t [s] is part of the motion: angles count their turns from
  /// there.
  void accept(double t, const ElementResponse& now);
  /// Its actions on the bodies, where it touches, or at its ends.
  std::array<ElementAction, 2> actions(const ElementResponse& now) const;

  double guard_value(const ElementGuard& guard, double t,
                     const ElementResponse& now) const override;

  /// Whether friction holds the line, as a constraint.
  bool sticks() const { return is_dry() && modes[0] == 0; }
  /// Breakaway effort under its load [N] or [N m].
  double breakaway(const ElementResponse& now) const {
    return now.load * breakaway_per_load();
  }
  /// Joint whose force its friction is proportional to, or -1.
  int followed_joint() const { return follows_reaction() ? joint : -1; }

  /// Whether its effort is a smooth function of states alone, along its line.
  virtual bool has_smooth_effort() const { return false; }
  /// Inertia that turns with its line's coordinate [kg m²]: that of a rotor.
  virtual double inertia() const { return 0.0; }
  /// How it yields in a state of a motion; without directions: it does not.
  virtual ElementSpring spring(const Configuration& /*x*/,
                               const ElementState& /*state*/) const {
    return {};
  }
  /// Of a line that yields slowly otherwise than spring() does, or bears no
  /// more than so much: what its effort changes by as it sways, over that way
  /// [N/m] or [N m/rad].
  virtual std::optional<double> slow_stiffness(
      const LineAtRest& /*line*/) const {
    return std::nullopt;
  }
  /// Whether it has a line along which a scalar effort acts.
  virtual bool is_line() const { return false; }

  PlacedJoint::Levers apart(int end, const ElementResponse& now) const override;
  double apart_bias(int end, const ElementResponse& now, const Twist& a,
                    const Twist& b) const override;

  JointModel line;  ///< J: its ends; a contact's plane (a) and centre (b)
  JointRow row;     ///< what a line measures
  Eigen::Matrix3d R_PW = Eigen::Matrix3d::Identity();
  int joint = -1;      ///< whose coordinate a line measures
  AngleAnchor anchor;  ///< of a line that counts turns

 protected:
  /// Joins two points; bodies referred to their M.
  void join(const ElementPoint& a, const ElementPoint& b,
            const ReferenceFrame& frame);
  /// Sets q, rate, effort, on_a and on_b where now.placed says.
  /// @param a, b  motions of the bodies.
  virtual void act(const ActingState& state, const Twist& a, const Twist& b,
                   ElementResponse& now) const = 0;
  PlacedJoint placed_in(const Configuration& x) const;
  /// From J on each body to where it is touched, in P [m].
  virtual std::array<Eigen::Vector3d, 2> touched(
      const ElementResponse& /*now*/) const {
    return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  }
};

/// Rotation that takes z to a direction, a unit vector.
Eigen::Matrix3d with_z_along(const Eigen::Vector3d& direction);

}  // namespace clevis::mechanism
