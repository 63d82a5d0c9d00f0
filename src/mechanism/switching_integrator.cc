#include "mechanism/switching_integrator.h"

namespace clevis::mechanism {
namespace {

// Explicit steps after which the other method is tried where they creep: so
// many more would be needed to the next break. Round-off of states that hardly
// move can hide from DOP853's own test that stability limits its steps.
constexpr int kPatience = 2000;
constexpr double kCreeping = 2e5;
// Every so many explicit steps the eigenvalues are looked at: DOP853's own test
// misses a stiff state that hardly moves.
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

void SwitchingIntegrator::change() {
  const double t = active_->t(), step = active_->next_step();
  state_ = active_->y();
  Integrator* other = &implicit_;
  if (active_ == other) other = &explicit_;
  active_ = other;
  since_change_ = 0;
  active_->restart(t, state_, step);
}

bool SwitchingIntegrator::step(double limit) {
  const bool creeps = active_ == &explicit_ && since_change_ > kPatience &&
                      limit - active_->t() > kCreeping * active_->next_step();
  if (may_change_ && (creeps || active_->wants_change() || is_stiff())) {
    change();
  }
  ++since_change_;
  bool done = active_->step(limit);
  if (!done && may_change_ && active_ == &explicit_) {
    change();
    done = active_->step(limit);
  }
  count();
  return done;
}

/// Whether stability limits the explicit steps; looked at now and then.
bool SwitchingIntegrator::is_stiff() {
  if (active_ != &explicit_ || since_change_ == 0 ||
      since_change_ % kLook != 0) {
    return false;
  }
  state_ = active_->y();
  const double h = active_->t() - active_->t_start();
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

}  // namespace clevis::mechanism
