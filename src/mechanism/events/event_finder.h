#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "mechanism/equations_of_motion/equations_of_motion.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// Finds where the modes of force elements end within a step: where their event
/// functions are negative at a sample, or between samples near to which they
/// vanish and bend enough to have been negative in between.
class EventFinder {
 public:
  /// @param definition  of the motion; its sines tell how often to look at
  ///   what rests.
  EventFinder(EquationsOfMotion& equations,
              const MechanismDefinition& definition);

  /// A state from which the modes hold, of StateLayout, at t [s].
  void start(double t, const Eigen::VectorXd& y);

  struct Event {
    int index = -1;  ///< see element_modes.h, or −1: the modes hold to the end
    double t{};
  };
  /// The first one in the integrator's last step.
  Event find(numerics::Integrator& integrator);

 private:
  static constexpr int kPieces = 4;  ///< of a window
  static constexpr int kDeepest = 20;

  struct Sample {
    double t{};
    Eigen::VectorXd values;
  };

  long windows(double start, double end);
  Event find_in_window(numerics::Integrator& integrator);
  Event find_between(numerics::Integrator& integrator, const Sample& left,
                     const Sample& right, int depth);
  Event first_root(numerics::Integrator& integrator, const Sample& left,
                   const Sample& right);
  bool may_dip(const Sample& left, const Sample& right,
               const Eigen::VectorXd& bend) const;
  bool any_negative(const Sample& sample) const;
  void measure(double t, const Eigen::VectorXd& y, Eigen::VectorXd& values);
  void measure_bends();
  void look(numerics::Integrator& integrator, double t, bool carefully,
            Eigen::VectorXd& values);
  double value(numerics::Integrator& integrator, int event, double t);
  double root(numerics::Integrator& integrator, int event, const Sample& left,
              double right);

  EquationsOfMotion& equations_;
  double longest_look_;  ///< at what rests [s]
  double windows_at_rest_ = 0.0;
  int looks_left_{};  ///< between samples, in this window
  std::array<Sample, kPieces + 1> samples_;
  /// By depth of halving: how much functions bend over an interval, and the
  /// sample in its middle.
  std::array<Eigen::VectorXd, kDeepest + 1> bends_;
  std::array<Sample, kDeepest> middles_;
  Eigen::VectorXd floors_, all_, state_;
};

}  // namespace clevis::mechanism
