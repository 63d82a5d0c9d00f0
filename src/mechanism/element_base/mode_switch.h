#pragma once

#include <array>
#include <vector>

#include "mechanism/element_base/element_response.h"

namespace clevis::mechanism {

/// Function of a driven motion that vanishes where an element's law goes from
/// one piece to the next.
struct ElementGuard {
  enum class Kind { kDepth, kRate, kPosition, kOwn } kind{};
  int end = 0;  ///< of a stop; whatever tells an element's own guards apart
  double level{};
};

/// Laws of several pieces, followed piece by piece: `modes` say which pieces
/// hold, two events per element when they end. An element of one piece keeps
/// the defaults. `now`: its response to the state at hand.
class ModeSwitch {
 public:
  virtual bool may_switch() const { return false; }
  /// Sets the modes that the state alone suggests; friction at rest sticks.
  virtual void choose_modes(const ElementResponse& /*now*/) {}
  /// Positive while mode `end` (0 or 1) holds; 1 where nothing can change; in
  /// units of the element (SI).
  virtual double event_value(int /*end*/,
                             const ElementResponse& /*now*/) const {
    return 1.0;
  }
  /// Goes on to the mode that follows after event_value() has reached zero.
  /// That friction whose speed vanishes sticks is a guess: the caller judges.
  virtual void pass_event(int /*end*/, const ElementResponse& /*now*/) {}
  /// "press", "release", "stick", "slip", "turn": name of the change to the
  /// present mode of an end; null if there was none to speak of.
  virtual const char* name_of_change(int /*end*/, int /*mode_before*/) const {
    return nullptr;
  }
  /// Borders between the pieces of its law in a motion that drives fix.
  virtual std::vector<ElementGuard> guards() const { return {}; }
  /// At t [s], in units of the element (SI).
  virtual double guard_value(const ElementGuard& guard, double t,
                             const ElementResponse& now) const = 0;
  /// Whether its zero changes anything.
  virtual bool guard_matters(const ElementGuard&,
                             const ElementResponse& /*now*/) const {
    return true;
  }

  std::array<int, 2> modes{};
  /// Velocity tolerance: bristles turn late by that, and no law is regularised
  /// by less [m/s] or [rad/s].
  double velocity_tolerance{};
  /// Speed beyond which a line that rests without a row of its own slips.
  double break_free_speed{};

 protected:
  ~ModeSwitch() = default;
};

}  // namespace clevis::mechanism
