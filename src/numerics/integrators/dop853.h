#pragma once

#include <array>

#include "numerics/integrators/dop853_coefficients.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::numerics {

/// Explicit Runge–Kutta method of order 8 with step control and dense output
/// of order 7.
class Dop853 : public Integrator {
 public:
  explicit Dop853(OdeSystem& system);

  void restart(double t, const Eigen::VectorXd& y, double step) override;
  bool step(double limit) override;
  double t_start() const override { return t_start_; }
  double t() const override { return t_; }
  const Eigen::VectorXd& y() const override { return y_; }
  void interpolate(double t, Eigen::VectorXd& y) override;
  void correct(const Eigen::VectorXd& y) override;
  /// Stability, not accuracy, limits the steps.
  bool wants_change() const override { return stiff_steps_ >= kStiffSteps; }
  double next_step() const override { return h_; }

 private:
  static constexpr int kStiffSteps = 15;

  double first_step();
  double attempt(double h);
  double error(double h);
  void judge_stiffness(double h);
  void prepare_dense();

  OdeSystem& system_;
  double t_start_{}, t_{}, h_{}, last_error_{};
  int stiff_steps_{}, calm_steps_{};
  bool dense_ready_ = false;
  Eigen::VectorXd y_start_, y_, trial_, stage_, weights_, scratch_;
  std::array<Eigen::VectorXd, dop853::kAllStages> k_;
  Eigen::VectorXd slope_;  ///< at (t_, y_)
  std::array<Eigen::VectorXd, 7> dense_;
};

}  // namespace clevis::numerics
