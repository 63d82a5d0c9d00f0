#include "mechanism/integration/motion_integrator.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

MotionIntegrator::MotionIntegrator(const MechanismDefinition& definition,
                                   const SolvingFrame& frame,
                                   ForwardDynamics& dynamics,
                                   numerics::IntegratorChoice choice)
    : dynamics_(dynamics),
      bodies_(dynamics, choice),
      coordinates_(JointCoordinates::of(frame, definition.drives)),
      active_(&bodies_),
      y_(VectorXd::Zero(dynamics.size())),
      scratch_(y_) {
  if (!coordinates_ ||
      !TreeSystem::can_follow(*coordinates_, dynamics.equations().forces())) {
    return;
  }
  tree_ = std::make_unique<TreeSystem>(definition, dynamics, *coordinates_);
  joints_.emplace(*tree_, choice);
  z_.setZero(tree_->size());
}

void MotionIntegrator::restart(double t, const VectorXd& y, double step) {
  active_ = joints_ && dynamics_.equations().has_joints_alone() ? &*joints_
                                                                : &bodies_;
  if (in_joints()) {
    tree_->start(t, y, z_);
    active_->restart(t, z_, step);
  } else {
    active_->restart(t, y, step);
  }
  count();
}

bool MotionIntegrator::step(double limit) {
  const bool done = active_->step(limit);
  count();
  return done;
}

/// Expanded anew, as the dynamics then know the turns at this time.
const VectorXd& MotionIntegrator::y() const {
  if (!in_joints()) return active_->y();
  tree_->expand(active_->t(), active_->y(), y_);
  return y_;
}

void MotionIntegrator::interpolate(double t, VectorXd& y) {
  if (!in_joints()) return active_->interpolate(t, y);
  active_->interpolate(t, z_);
  tree_->expand(t, z_, y);
}

void MotionIntegrator::state_at(double t, VectorXd& y) {
  if (!in_joints()) return active_->state_at(t, y);
  active_->state_at(t, z_);
  tree_->expand(t, z_, y);
}

void MotionIntegrator::correct(const VectorXd& y) {
  if (!in_joints()) return active_->correct(y);
  tree_->expand(active_->t(), active_->y(), y_);
  if (differs_by_round_off(y)) return;
  z_ = active_->y();
  tree_->read(active_->t(), y, z_);
  active_->correct(z_);
}

/// States in joints hold the bodies together as they are. What comes back from
/// the bodies with round-off would add up from step to step.
bool MotionIntegrator::differs_by_round_off(const VectorXd& y) {
  constexpr double kPart = 1e-11;
  dynamics_.scales(y, scratch_);
  return ((y - y_).array().abs() <=
          kPart * scratch_.array().max(y.array().abs()))
      .all();
}

void MotionIntegrator::count() {
  counts_ = bodies_.counts();
  if (!joints_) return;
  const numerics::StepCounts& more = joints_->counts();
  counts_.steps += more.steps;
  counts_.rejected += more.rejected;
  counts_.evaluations += more.evaluations;
  counts_.factorisations += more.factorisations;
}

long MotionIntegrator::implicit_steps() const {
  return bodies_.implicit_steps() + (joints_ ? joints_->implicit_steps() : 0);
}

std::string MotionIntegrator::method() const {
  const long implicit = implicit_steps();
  const bool both = implicit > 0 && implicit < counts_.steps;
  if (both) return "DOP853 and Radau IIA";
  return implicit > 0 ? "Radau IIA" : "DOP853";
}

}  // namespace clevis::mechanism
