#pragma once

#include "numerics/integrators/dop853.h"
#include "numerics/integrators/integrator_choice.h"
#include "numerics/integrators/radau.h"

namespace clevis::numerics {

/// DOP853 where accuracy limits the steps, Radau IIA where stability would;
/// changes between them as the motion goes.
class SwitchingIntegrator : public Integrator {
 public:
  SwitchingIntegrator(OdeSystem& system, IntegratorChoice choice);

  void restart(double t, const Eigen::VectorXd& y, double step) override;
  bool step(double limit) override;
  double t_start() const override { return active_->t_start(); }
  double t() const override { return active_->t(); }
  const Eigen::VectorXd& y() const override { return active_->y(); }
  void interpolate(double t, Eigen::VectorXd& y) override {
    active_->interpolate(t, y);
  }
  void state_at(double t, Eigen::VectorXd& y) override {
    active_->state_at(t, y);
  }
  void correct(const Eigen::VectorXd& y) override { active_->correct(y); }
  bool wants_change() const override { return false; }
  double next_step() const override { return active_->next_step(); }

  long implicit_steps() const { return implicit_.counts().steps; }

 private:
  void change(double from);
  bool is_stiff(double limit);
  void count();

  Dop853 explicit_;
  Radau implicit_;
  Integrator* active_;
  bool may_change_;
  long since_change_ = 0, since_look_ = 0;  ///< steps
  Eigen::VectorXd state_;
};

}  // namespace clevis::numerics
