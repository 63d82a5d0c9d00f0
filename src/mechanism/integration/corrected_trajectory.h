#pragma once

#include <Eigen/Core>

#include "mechanism/equations_of_motion/projection.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// Positions of an integrated motion as one continuous function of time,
/// through the corrected states at the ends of its steps. Times [s], states in
/// the units of StateLayout.
///
/// Within a step it is the dense output and a part of the end's correction that
/// grows with time. Beside a change point accelerations of a step's stages, and
/// with them the dense output, may be wrong by far more than its ends: where
/// joints are violated less between these ends' positions joined by cubics, by
/// their velocities, that is the path.
class CorrectedTrajectory {
 public:
  CorrectedTrajectory(EquationsOfMotion& equations, Projection& projection)
      : equations_(equations), projection_(projection) {}

  /// The next step begins at y.
  void restart(const Eigen::VectorXd& y) { end_ = state_ = y; }
  /// The integrator's last step as far as `until`.
  /// @param end  the corrected state there.
  void follow(numerics::Integrator& integrator, double until,
              const Eigen::VectorXd& end);
  /// Only its positions count. @pre within that step.
  const Eigen::VectorXd& state_at(double t);

 private:
  void choose();
  void put_dense(double t);
  void put_cubic(double t);

  EquationsOfMotion& equations_;
  Projection& projection_;
  numerics::Integrator* integrator_ = nullptr;
  double from_{}, until_{};
  bool is_chosen_{}, is_dense_{};
  Eigen::VectorXd start_, end_, start_rate_, end_rate_, correction_, state_;
};

}  // namespace clevis::mechanism
