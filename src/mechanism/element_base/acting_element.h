#pragma once

#include <array>
#include <limits>
#include <vector>

#include "mechanism/element_base/element_state.h"
#include "mechanism/element_base/force_line.h"
#include "mechanism/joints/configuration.h"
#include "numerics/curves/linear_table.h"

namespace clevis::mechanism {

/// What forces act on: an instant of a motion.
struct ActingState {
  double t{};  ///< [s]
  const Configuration& configuration;
  const std::vector<Twist>& twists;  ///< by slot
  const double* internal{};          ///< states of all elements
  numerics::StepSide side{};         ///< of a table's step at t
};

/// Function of a driven motion that vanishes where an element's law goes from
/// one piece to the next.
struct ElementGuard {
  enum class Kind { kDepth, kRate, kPosition, kOwn } kind{};
  int end = 0;  ///< of a stop; whatever tells an element's own guards apart
  double level{};
};

/// A force element placed between two bodies, and what it does in a state.
///
/// Laws of several pieces are followed piece by piece: `modes` say which
/// pieces hold, two events per element when they end. Kinds override what
/// they do otherwise than an element without modes, states and ends.
class ActingElement {
 public:
  ActingElement();
  virtual ~ActingElement() = default;
  ActingElement(const ActingElement&) = delete;
  ActingElement& operator=(const ActingElement&) = delete;

  /// Computes what is "as of evaluate()". Sticking friction has no effort of
  /// its own.
  void evaluate(const ActingState& state);
  /// The state of the last evaluate() is part of the motion: angles count
  /// their turns from there.
  void accept(double t);
  /// What it does to its bodies, as of evaluate(); where it touches, or at its
  /// ends.
  std::array<ElementAction, 2> actions() const;

  // States of its own
  virtual int internal_states() const { return 0; }
  /// States of the start. @throws Error K009.
  virtual void start(const Configuration&, double* /*own*/) {}
  /// Scale of its states, for error weights.
  virtual void scales(const double* /*own*/, double* /*scales*/) const {}
  /// When it and the mechanism communicate next [s]; never if they are
  /// integrated together.
  virtual double next_communication() const {
    return std::numeric_limits<double>::infinity();
  }
  /// They do, as of the last evaluate().
  virtual void communicate(double /*t*/) {}

  // Modes and events
  virtual bool may_switch() const { return false; }
  /// Sets the modes that the state alone suggests; friction at rest sticks.
  virtual void choose_modes() {}
  /// Positive while mode `end` (0 or 1) holds, as of evaluate(); 1 where
  /// nothing can change.
  virtual double event_value(int /*end*/) const { return 1.0; }
  /// Goes on to the mode that follows after event_value() has reached zero.
  /// That friction whose speed vanishes sticks is a guess: the caller judges.
  virtual void pass_event(int /*end*/) {}
  /// "press", "release", "stick", "slip", "turn": what the change to the
  /// present mode of an end was; null if there was none to speak of.
  virtual const char* name_of_change(int /*end*/, int /*mode_before*/) const {
    return nullptr;
  }
  /// What separates the pieces of its law in a motion that drives fix.
  virtual std::vector<ElementGuard> guards() const { return {}; }
  virtual double guard_value(const ElementGuard& guard, double t) const;
  /// Whether its zero changes anything, as of evaluate().
  virtual bool guard_matters(const ElementGuard&) const { return true; }

  // Friction
  /// Coulomb friction, whose modes are decided together.
  virtual bool is_dry() const { return false; }
  /// Whether friction holds the line, as a constraint.
  bool sticks() const { return is_dry() && modes[0] == 0; }
  /// Breakaway effort over `load`: [N], [N m], [1] or [m].
  virtual double breakaway_per_load() const { return 0.0; }
  double breakaway() const { return load * breakaway_per_load(); }
  /// Joint whose force its friction is proportional to, or -1.
  int followed_joint() const { return follows_reaction ? joint : -1; }
  /// Speed below which Stribeck's term of friction counts, of a contact the
  /// peak about its critical speed; 0 without one. A step that passes it must
  /// be short, as nothing else tells of a peak so narrow.
  virtual double stribeck_zone() const { return 0.0; }
  /// Deflection of bristles at breakaway [m] or [rad]; infinite without them.
  virtual double bristle_deflection() const {
    return std::numeric_limits<double>::infinity();
  }
  /// Its friction acts by the tangent at the state of the last evaluate(),
  /// until release_tangent().
  virtual void hold_tangent(const double* /*internal*/) {}
  virtual void release_tangent() {}

  // Effort and inertia
  /// Whether its effort is a smooth function of states alone, along its line.
  virtual bool has_smooth_effort() const { return false; }
  /// Inertia that turns with its line's coordinate [kg m²]: that of a rotor.
  virtual double inertia() const { return 0.0; }
  /// Whether it has a line along which a scalar effort acts.
  virtual bool is_line() const { return false; }
  /// Lets a line act with an effort.
  void act_along(double new_effort);

  // Ends that press
  virtual bool presses() const { return false; }
  /// A unit force that pushes a and b apart at a pressing end.
  virtual PlacedJoint::Levers apart(int end) const;
  /// What velocities alone add to the acceleration apart.
  virtual double apart_bias(int end, const Twist& a, const Twist& b) const;
  /// Of a contact's sliding, without what velocities cause [m/s²].
  virtual double sliding_acceleration(const Twist& /*a*/,
                                      const Twist& /*b*/) const {
    return 0.0;
  }

  /// Adds what its kind alone has to say. @param t  of evaluate().
  virtual void report(double /*t*/, ElementState&) const {}

  JointModel line;  ///< J: its ends; a contact's plane (a) and centre (b)
  JointRow row;     ///< what a line measures
  Eigen::Matrix3d R_PW = Eigen::Matrix3d::Identity();
  int joint = -1;                 ///< whose coordinate a line measures
  bool follows_reaction = false;  ///< friction per newton of that joint's force
  int internal = -1;              ///< index of its first internal state
  std::array<int, 2> modes{};
  /// As of accept() or anchor(): from there turns are counted.
  double q_start{}, rate_start{}, t_start{};
  /// Velocity tolerance: bristles turn late by that, and no law is regularised
  /// by less [m/s] or [rad/s].
  double slack{};
  /// Speed beyond which a line that rests without a row of its own slips.
  double leaving{};

  // as of evaluate()
  PlacedJoint placed;
  PlacedJoint::Levers levers;  ///< of a line
  double q{}, rate{};          ///< of a line; a contact's depth; [m] or [rad]
  double effort{};             ///< on b, > 0 pushes apart; normal force
  double friction{};           ///< of a contact [N]
  /// What friction is proportional to: 1, or the joint's force if it follows
  /// that; 0 until that is known [N].
  double load = 1.0;
  double per_load{}, own_effort{};  ///< effort = load × per_load + own_effort
  std::vector<double> internal_rates;           ///< one per internal state
  std::array<double, 2> depth{}, depth_rate{};  ///< by end, or of a contact
  /// Effort of a pressing end whatever its mode, without the bound at 0.
  std::array<double, 2> unbounded{};
  Twist on_a{}, on_b{};  ///< force and moment about M
  double power{};        ///< [W]

 protected:
  /// Joins two points; bodies referred to their M.
  void join(const ElementPoint& a, const ElementPoint& b,
            const ReferenceFrame& frame);
  /// Sets q, rate, effort, on_a and on_b. @param a, b  motions of the bodies.
  virtual void act(const ActingState& state, const Twist& a,
                   const Twist& b) = 0;
  /// From J on each body to where it is touched, in P [m].
  virtual std::array<Eigen::Vector3d, 2> touched() const {
    return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  }
};

/// Rotation that takes z to a direction.
Eigen::Matrix3d with_z_along(const Eigen::Vector3d& direction);

}  // namespace clevis::mechanism
