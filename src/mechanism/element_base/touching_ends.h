#pragma once

#include "mechanism/element_base/element_response.h"

namespace clevis::mechanism {

/// Ends of a force element that press on what they touch: of a stop, or a
/// contact. `now`: its response to the state at hand.
class TouchingEnds {
 public:
  /// Whether end 0 or 1 is one.
  virtual bool presses(int /*end*/) const { return false; }
  /// A unit force that pushes a and b apart at a pressing end.
  virtual PlacedJoint::Levers apart(int end,
                                    const ElementResponse& now) const = 0;
  /// Part of the acceleration apart that velocities alone cause [m/s²],
  /// [rad/s²].
  virtual double apart_bias(int end, const ElementResponse& now, const Twist& a,
                            const Twist& b) const = 0;
  /// Of a contact's sliding, without what velocities cause [m/s²].
  virtual double sliding_acceleration(const ElementResponse& /*now*/,
                                      const Twist& /*a*/,
                                      const Twist& /*b*/) const {
    return 0.0;
  }

 protected:
  ~TouchingEnds() = default;
};

}  // namespace clevis::mechanism
