#pragma once

#include <limits>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// All force elements of a mechanism, evaluated without allocation.
///
/// SI: times [s], coordinates of lines [m] or [rad], their efforts [N] or
/// [N m], accelerations [m/s²] or [rad/s²]; internal states in the units of
/// their elements.
class ForceModel {
 public:
  ForceModel(const MechanismDefinition& definition, const SolvingFrame& frame);

  ForceModel(const ForceModel&) = delete;
  ForceModel& operator=(const ForceModel&) = delete;

  bool empty() const { return elements_.empty(); }
  /// Whether there are events.
  bool may_switch() const { return may_switch_; }
  std::size_t size() const { return elements_.size(); }
  int internal_states() const { return internal_states_; }

  /// Internal states of the start. @throws Error K009.
  void start_internal(const Configuration& x, double* internal);
  /// Tables act from now on, at t itself too, as behind a step at t; until
  /// then as before it at the later end of a piece.
  void enter_piece(double t) { piece_start_ = t; }
  /// @param internal  internal states (bristles, gas, currents).
  void evaluate(double t, const Configuration& x,
                const std::vector<Twist>& twists, const double* internal);
  /// When elements communicate with the mechanism next [s].
  double next_communication() const;
  /// Exchanges data of all co-simulated elements whose communication time has
  /// come. @pre evaluate(t).
  void communicate(double t);
  /// See accept() of an element.
  void accept(double t);
  /// The angle of an element's line and its rate are known at t: turns are
  /// counted from there.
  void anchor(std::size_t k, double angle, double rate, double t) {
    ActingElement& e = *elements_[k];
    e.q_start = angle;
    e.rate_start = rate;
    e.t_start = t;
  }
  /// Adds the wrenches about M, by slot.
  void add_to(std::vector<Twist>& wrenches) const;
  /// Rates of the internal states, as of evaluate().
  void internal_rates(double* rates) const;
  /// Scale of the internal states, for error weights.
  void internal_scales(const double* internal, double* scales) const;

  /// Modes that the state of the last evaluate() suggests.
  void choose_modes();

  /// Sticking friction is a constraint: its row, as levers and bias.
  bool sticks(std::size_t k) const { return elements_[k]->sticks(); }
  bool any_sticks() const;
  /// Whether the line of any element counts its turns.
  bool counts_turns() const;
  bool is_angle(std::size_t k) const { return elements_[k]->row.is_angle(); }
  const ActingElement& element(std::size_t k) const { return *elements_[k]; }
  /// Whether an element brings a row of its own: it sticks, or a rotor turns
  /// with it.
  bool brings_row(std::size_t k) const { return sticks(k) || inertia(k) > 0.0; }
  double inertia(std::size_t k) const { return elements_[k]->inertia(); }
  /// Part of the line's acceleration that velocities cause.
  double line_bias(std::size_t k, const std::vector<Twist>& twists) const;
  /// Rate of the joint's angle along which element k acts [rad/s].
  double joint_rate(std::size_t k, const std::vector<PlacedJoint>& placed,
                    const std::vector<Twist>& twists) const;
  double line_acceleration(std::size_t k,
                           const std::vector<Twist>& accelerations,
                           const std::vector<Twist>& twists) const;
  /// Of a contact's sliding, without what velocities cause [m/s²].
  double sliding_acceleration(std::size_t k,
                              const std::vector<Twist>& accelerations) const;
  /// Coulomb friction, whose modes are decided together.
  bool is_dry(std::size_t k) const { return elements_[k]->is_dry(); }
  /// Gives a sticking element the effort that holds it. Adds to a motor's
  /// effort that of the row of its rotor.
  void set_row_effort(std::size_t k, double effort);
  double breakaway(std::size_t k) const { return elements_[k]->breakaway(); }
  /// Lines whose effort is a smooth function of states alone.
  std::vector<std::size_t> with_smooth_efforts() const;
  /// Gives such a line an effort in place of its law's.
  void set_effort(std::size_t k, double effort);
  /// Gives friction that follows a reaction its load, and with it, unless it
  /// sticks, its effort.
  void set_load(std::size_t k, double load);
  /// Dry friction that moves against its mode by more than speeds may err, as
  /// of evaluate(): at rest it moves, or slips with its own force. size() if
  /// there is none.
  std::size_t line_against_its_mode() const;
  void set_mode(std::size_t k, int mode) { elements_[k]->modes[0] = mode; }

  /// See OdeSystem. @param internal  of the last evaluate().
  void hold_tangents(const double* internal);
  void release_tangents();
  /// @param slack, leaving  see ActingElement [m/s], of turns over the length.
  /// @param per_second  bristles creep by this part of their deflection at
  ///   most [1/s].
  void set_slack(double slack, double leaving, double length,
                 double per_second);

  /// Two per element: positive while its modes hold, as of evaluate() and
  /// set_row_effort().
  int events() const { return static_cast<int>(2 * elements_.size()); }
  void event_values(Eigen::VectorXd& values) const;
  /// Goes to the next mode of what event_values() found at zero.
  void pass_event(int event);
  std::vector<int> modes() const;  ///< by event
  /// What changed at that event. @param before  modes().
  std::vector<MotionEvent> changes(int event, double t,
                                   const std::vector<int>& before) const;
  /// Times at which tables and the paths of targets bend.
  std::vector<double> breakpoint_times() const;

  std::vector<ElementState> states() const;

 private:
  std::vector<ForceElement> definitions_;
  std::vector<std::unique_ptr<ActingElement>> elements_;
  int internal_states_ = 0;
  bool may_switch_ = false;
  double t_{};  ///< of evaluate()
  /// Pieces between bends follow one another in integrations alone [s].
  double piece_start_ = std::numeric_limits<double>::infinity();
};

}  // namespace clevis::mechanism
