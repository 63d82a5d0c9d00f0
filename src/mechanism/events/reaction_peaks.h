#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/equations_of_motion/equations_of_motion.h"
#include "mechanism/sampling/load_list.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// Watches an integration for the times at which each of its loads is largest:
/// the force and the moment of each joint, as far as they hold the motion,
/// the efforts of drives and force elements. Times are in seconds [s].
class ReactionPeaks {
 public:
  explicit ReactionPeaks(EquationsOfMotion& equations);

  /// The start, and each state from which the integrator starts anew: forces
  /// may jump there.
  void restart(double t, const Eigen::VectorXd& y);
  /// Looks at the integrator's last step, up to a time.
  void look(numerics::Integrator& integrator, double until);
  /// Increasing, those at the same time once.
  std::vector<double> times() const;
  const LoadList& list() const { return list_; }
  /// By vector of the list: squares [N²] or [N² m²], and their times [s].
  const Eigen::VectorXd& largest() const { return largest_; }
  const Eigen::VectorXd& at() const { return at_; }

 private:
  struct Sample {
    double t{};
    Eigen::VectorXd values;
  };
  void measure(double t, const Eigen::VectorXd& y, Eigen::VectorXd& values);
  void note(const Sample& sample);
  bool may_exceed(Eigen::Index which) const;
  /// Narrows a maximum down between two times of the last step.
  void refine(numerics::Integrator& integrator, Eigen::Index which, double from,
              double to);

  EquationsOfMotion& equations_;
  LoadList list_;
  Sample before_, last_, next_;
  bool has_before_ = false;
  Eigen::VectorXd largest_, at_, state_, loads_, values_;
};

}  // namespace clevis::mechanism
