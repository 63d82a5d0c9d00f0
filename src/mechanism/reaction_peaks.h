#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/forward_dynamics.h"
#include "mechanism/ode_system.h"

namespace clevis::mechanism {

/// Watches an integration for the times at which the force and the moment of
/// each joint, as far as they hold the motion, are largest.
class ReactionPeaks {
 public:
  explicit ReactionPeaks(ForwardDynamics& dynamics);

  /// The start, and each state from which the integrator starts anew: forces
  /// may jump there.
  void restart(double t, const Eigen::VectorXd& y);
  /// Looks at the integrator's last step, up to a time.
  void look(Integrator& integrator, double until);
  /// Increasing; one or two per joint, those at the same time once.
  std::vector<double> times() const;

 private:
  struct Sample {
    double t{};
    Eigen::VectorXd values;
  };
  void measure(double t, const Eigen::VectorXd& y, Eigen::VectorXd& values);
  void note(const Sample& sample);
  /// Narrows a maximum down between two times of the last step.
  void refine(Integrator& integrator, Eigen::Index which, double from,
              double to);

  ForwardDynamics& dynamics_;
  Sample before_, last_, next_;
  bool has_before_ = false;
  Eigen::VectorXd largest_, at_, state_, rate_, values_;
};

}  // namespace clevis::mechanism
