#pragma once

#include <Eigen/Core>

#include "mechanism/forward_dynamics.h"
#include "mechanism/ode_system.h"

namespace clevis::mechanism {

/// Finds where the modes of force elements end within a step.
class EventFinder {
 public:
  explicit EventFinder(ForwardDynamics& dynamics);

  /// A state from which the modes hold.
  void start(double t, const Eigen::VectorXd& y);

  struct Event {
    int index = -1;  ///< of ForceModel, or −1: the modes hold to the end
    double t{};
  };
  /// The first one in the integrator's last step.
  Event find(Integrator& integrator);

 private:
  double value(Integrator& integrator, int event, double t);
  double root(Integrator& integrator, int event, double left, double at_left,
              double right);

  ForwardDynamics& dynamics_;
  Eigen::VectorXd values_, next_, all_, state_;
};

}  // namespace clevis::mechanism
