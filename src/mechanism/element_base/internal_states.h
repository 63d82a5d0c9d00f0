#pragma once

#include <limits>

#include "mechanism/element_base/element_response.h"
#include "mechanism/joints/configuration.h"

namespace clevis::mechanism {

/// Internal states of a force element: bristles, gas, currents, in units of
/// their own (SI). An element without any keeps the defaults.
class InternalStates {
 public:
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
  /// Exchanges data with the mechanism at t [s].
  virtual void communicate(double /*t*/, const ElementResponse& /*now*/) {}

  int internal = -1;  ///< index of its first internal state

 protected:
  ~InternalStates() = default;
};

}  // namespace clevis::mechanism
