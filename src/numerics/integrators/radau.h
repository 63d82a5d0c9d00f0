#pragma once

#include "numerics/integrators/collocation.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::numerics {

/// Implicit Runge–Kutta method Radau IIA, stiffly accurate, of five stages, or
/// of seven where errors allowed are small, with step control as in RADAU5
/// ([HairerWanner1996] IV.8).
class Radau : public Integrator {
 public:
  explicit Radau(OdeSystem& system);

  void restart(double t, const Eigen::VectorXd& y, double step) override;
  bool step(double limit) override;
  double t_start() const override { return t_start_; }
  double t() const override { return t_; }
  const Eigen::VectorXd& y() const override { return y_; }
  /// The collocation polynomial, of as many orders as there are stages.
  void interpolate(double t, Eigen::VectorXd& y) override;
  /// A step of its own from t_start(), of the order of steps.
  void state_at(double t, Eigen::VectorXd& y) override;
  void correct(const Eigen::VectorXd& y) override;
  /// Steps are so short that an explicit method would be stable.
  bool wants_change() const override { return easy_steps_ >= kEasySteps; }
  double next_step() const override { return h_; }
  /// About the largest eigenvalue of the system there, in size [1/s].
  double largest_eigenvalue(double t, const Eigen::VectorXd& y);

 private:
  static constexpr int kEasySteps = 10;

  /// Which axes Newton does better in, by what each did last.
  struct AxesChoice {
    std::array<double, 2> slowness{};  ///< contraction over step [1/s]
    std::size_t at = 0;

    void note(double contraction, double h) { slowness[at] = contraction / h; }
    Collocation::Axes choose();
  };

  void guess_stages(double h);
  void take_polynomial(double s, Eigen::VectorXd& z) const;
  double attempt(double h, bool careful);
  double error(double h, bool careful);
  void accept(double h, double error, double limit, bool rejected);
  void judge_stiffness(double h);
  void count();

  OdeSystem& system_;
  Collocation collocation_;
  double t_start_{}, t_{}, h_{}, last_h_{}, last_error_{};
  double longest_{};  ///< with which Newton is trusted to converge [s]
  bool has_past_ = false, fresh_jacobian_ = false, refresh_ = true;
  bool stale_slope_ = false;  ///< y_ was corrected since by very little
  AxesChoice axes_;
  int easy_steps_{};
  Eigen::VectorXd y_start_, y_, weights_, slope_, trial_slope_, scratch_,
      embedded_;
  const RadauMethod* last_method_;  ///< of the last step
  Collocation::Stages dense_;       ///< of the last step
};

}  // namespace clevis::numerics
