#pragma once

#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "mechanism/equations_of_motion/equations_of_motion.h"
#include "mechanism/sampling/load_list.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// Finds, along an integration, the times at which instants are wanted so
/// that large loads change little from one to the next, and more of them so
/// that all loads, small ones too, follow a smooth curve from one to the next.
/// Times are in seconds [s].
class LoadSampler {
 public:
  /// @param largest  squares by vector, as an earlier run found them [N²],
  ///   [N² m²].
  LoadSampler(EquationsOfMotion& equations, const Eigen::VectorXd& largest);

  /// The start, and each state from which the integrator starts anew.
  void restart(double t, const Eigen::VectorXd& y);
  /// Adds times within the last step, up to `until`, to `wanted`, and those of
  /// which only what vibrates takes notice to `followed`.
  /// @param known  increasing times that are instants anyway.
  void look(numerics::Integrator& integrator, double until,
            std::span<const double> known, std::vector<double>& wanted,
            std::vector<double>& followed);
  /// Up to there all loads are followed; infinite: to the end.
  double followed_until() const { return followed_until_; }
  /// Behind that the shortest step that would follow them; infinite: none.
  double step_behind() const { return step_behind_; }

 private:
  struct Sample {
    double t{};
    Eigen::VectorXd loads;
  };
  Sample at(numerics::Integrator& integrator, double t);
  void divide(numerics::Integrator& integrator, const Sample& from,
              const Sample& to, int depth, std::vector<double>& wanted);
  void straighten(numerics::Integrator& integrator);
  void follow(std::span<const double> known, std::vector<double>& wanted,
              std::vector<double>& followed);
  double off_curve(const Sample& from, const Sample& at, const Sample& to);

  EquationsOfMotion& equations_;
  LoadList list_;
  LoadChange change_;
  Sample taken_;                  ///< the last instant
  long most_;                     ///< instants that may still be added
  std::vector<Sample> step_;      ///< samples of the last step, rising
  std::vector<Sample> since_;     ///< from the last time that is followed on
  std::vector<Sample> followed_;  ///< at the last of such times
  long most_followed_;            ///< times that may still be followed
  double followed_until_ = std::numeric_limits<double>::infinity();
  double step_behind_ = std::numeric_limits<double>::infinity();
  Eigen::VectorXd state_, off_, miss_, swing_, apart_;
};

}  // namespace clevis::mechanism
