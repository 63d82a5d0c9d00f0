#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "mechanism/equations_of_motion/equations_of_motion.h"
#include "mechanism/sampling/load_list.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// Finds, along an integration, the times at which instants are wanted so
/// that large loads change little from one to the next. Times are in seconds
/// [s].
class LoadSampler {
 public:
  /// @param largest  squares by vector, as an earlier run found them [N²],
  ///   [N² m²].
  LoadSampler(EquationsOfMotion& equations, const Eigen::VectorXd& largest);

  /// The start, and each state from which the integrator starts anew.
  void restart(double t, const Eigen::VectorXd& y);
  /// Adds times within the last step, up to `until`, to `wanted`.
  /// @param known  increasing times that are instants anyway.
  void look(numerics::Integrator& integrator, double until,
            std::span<const double> known, std::vector<double>& wanted);

 private:
  struct Sample {
    double t{};
    Eigen::VectorXd loads;
  };
  Sample at(numerics::Integrator& integrator, double t);
  void divide(numerics::Integrator& integrator, const Sample& from,
              const Sample& to, int depth, std::vector<double>& wanted);

  EquationsOfMotion& equations_;
  LoadList list_;
  LoadChange change_;
  Sample taken_;  ///< the last instant
  long most_;     ///< instants that may still be added
  Eigen::VectorXd state_;
};

}  // namespace clevis::mechanism
