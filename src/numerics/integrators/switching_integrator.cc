#include "numerics/integrators/switching_integrator.h"

namespace clevis::numerics {
namespace {

// Explicit steps after which the other method is tried where they creep: so
// many more would be needed to the next break. Round-off of states that hardly
// move can hide from DOP853's own test that stability limits its steps.
constexpr int kPatience = 2000;
constexpr double kCreeping = 2e5;
// Every so many explicit steps the eigenvalues are looked at: DOP853's own test
// misses a stiff state that hardly moves. Where they creep at each: unstable
// dense output may let a stiff contact go and press it again without end.
constexpr int kLook = 100;
constexpr double kStable = 4.0;  // |h λ|, of the 6.1 that are stable

}  // namespace

SwitchingIntegrator::SwitchingIntegrator(OdeSystem& system,
                                         IntegratorChoice choice)
    : explicit_(system),
      implicit_(system),
      active_(&explicit_),
      may_change_(choice == IntegratorChoice::kAuto) {
  if (choice == IntegratorChoice::kImplicit) active_ = &implicit_;
  state_.setZero(system.size());
}

void SwitchingIntegrator::restart(double t, const Eigen::VectorXd& y,
                                  double step) {
  active_->restart(t, y, step);
  count();
}

/// @param from  of the last step, from which the other method goes on.
void SwitchingIntegrator::change(double from) {
  const double step =
      from < active_->t() ? active_->t() - from : active_->next_step();
  state_ = active_->y();
  if (from < active_->t()) active_->interpolate(from, state_);
  Integrator* other = &implicit_;
  if (active_ == other) other = &explicit_;
  active_ = other;
  since_change_ = since_look_ = 0;
  active_->restart(from, state_, step);
}

bool SwitchingIntegrator::step(double limit) {
  if (may_change_ && active_->wants_change()) change(active_->t());
  ++since_change_;
  ++since_look_;
  bool done = active_->step(limit);
  if (may_change_ && active_ == &explicit_ && (!done || is_stiff(limit))) {
    change(done ? active_->t_start() : active_->t());
    done = active_->step(limit);
  }
  count();
  return done;
}

/// Whether stability limits the explicit steps; looked at now and then.
bool SwitchingIntegrator::is_stiff(double limit) {
  const double h = active_->t() - active_->t_start();
  const bool creeps = limit - active_->t() > kCreeping * h;
  if (creeps && since_change_ > kPatience) return true;
  if (!creeps && since_look_ < kLook) return false;
  since_look_ = 0;
  state_ = active_->y();
  return h * implicit_.largest_eigenvalue(active_->t(), state_) > kStable;
}

void SwitchingIntegrator::count() {
  const StepCounts& a = explicit_.counts();
  const StepCounts& b = implicit_.counts();
  counts_ = {.steps = a.steps + b.steps,
             .rejected = a.rejected + b.rejected,
             .evaluations = a.evaluations + b.evaluations,
             .factorisations = b.factorisations};
}

}  // namespace clevis::numerics
