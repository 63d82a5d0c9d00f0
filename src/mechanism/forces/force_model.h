#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/motion.h"
#include "mechanism/element_base/acting_element.h"
#include "mechanism/forces/force_state.h"

namespace clevis::mechanism {

/// All force elements of a mechanism, evaluated without allocation. Their
/// modes and events: element_modes.h; their lines: line_motion.h.
///
/// SI: times [s], coordinates of lines [m] or [rad], their efforts [N] or
/// [N m]; internal states in the units of their elements.
class ForceModel {
 public:
  ForceModel(const MechanismDefinition& definition, const SolvingFrame& frame);

  ForceModel(const ForceModel&) = delete;
  ForceModel& operator=(const ForceModel&) = delete;

  bool empty() const { return elements_.empty(); }
  std::size_t size() const { return elements_.size(); }
  int internal_states() const { return internal_states_; }
  const ActingElement& element(std::size_t k) const { return *elements_[k]; }
  ActingElement& element(std::size_t k) { return *elements_[k]; }

  /// Internal states of the start. @throws Error K009.
  void start_internal(const Configuration& x, double* internal);
  /// Tables act from now on, at t itself too, as behind a step at t; until
  /// then as before it at the later end of a piece.
  void enter_piece(double t) { piece_start_ = t; }

  /// A state without efforts, of the sizes that evaluate() fills.
  ForceState none() const;
  /// Puts the elements' responses. @param internal  bristles, gas, currents.
  void evaluate(double t, const Configuration& x,
                const std::vector<Twist>& twists, const double* internal,
                ForceState& state) const;
  /// Adds the wrenches about M, by slot [N], [N m].
  void add_to(const ForceState& state,
              std::vector<SpatialForce>& wrenches) const;
  /// The same as results, in W.
  std::vector<ElementState> results(const ForceState& state) const;

  /// When elements communicate with the mechanism next [s].
  double next_communication() const;
  /// Exchanges data of all co-simulated elements whose communication time has
  /// come. @param state  at t.
  void communicate(double t, const ForceState& state);
  /// See accept() of an element. @param state  at t.
  void accept(double t, const ForceState& state);
  /// Scale of the internal states, for error weights.
  void internal_scales(const double* internal, double* scales) const;

  /// See OdeSystem. @param internal  of that state.
  void hold_tangents(const ForceState& state, const double* internal);
  void release_tangents();
  /// @param velocity_tolerance, break_free_speed  see ModeSwitch [m/s], of
  /// turns
  ///   over the length.
  /// @param per_second  bristles creep by this part of their deflection at
  ///   most [1/s].
  void set_velocity_tolerance(double velocity_tolerance,
                              double break_free_speed, double length,
                              double per_second);
  /// Times at which tables and the paths of targets bend.
  std::vector<double> breakpoint_times() const;

 private:
  std::vector<ForceElement> definitions_;
  std::vector<std::unique_ptr<ActingElement>> elements_;
  int internal_states_ = 0;
  /// Pieces between bends follow one another in integrations alone [s].
  double piece_start_ = std::numeric_limits<double>::infinity();
};

}  // namespace clevis::mechanism
