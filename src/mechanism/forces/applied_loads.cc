#include "mechanism/forces/applied_loads.h"

namespace clevis::mechanism {
namespace {

/// Lines whose effort is a smooth function of states alone.
std::vector<std::size_t> with_smooth_efforts(const ForceModel& forces) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).has_smooth_effort()) found.push_back(k);
  }
  return found;
}

}  // namespace

double LoadState::power(const std::vector<Twist>& twists) const {
  double power = 0.0;
  for (std::size_t i = 1; i < wrenches.size(); ++i) {
    power += wrenches[i].v.dot(twists[i].v) + wrenches[i].w.dot(twists[i].w);
  }
  return power;
}

AppliedLoads::AppliedLoads(const MechanismDefinition& definition,
                           const SolvingFrame& frame)
    : forces_(definition, frame),
      masses_(frame.placement.size()),
      gravity_(frame.R_WP.transpose() * definition.gravity_W),
      stiff_(with_smooth_efforts(forces_)) {
  for (std::size_t i = 1; i < masses_.size(); ++i) {
    masses_[i] = definition.bodies[i - 1].mass_properties.mass;
  }
}

LoadState AppliedLoads::none() const {
  return {.forces = forces_.none(),
          .wrenches = std::vector<Twist>(masses_.size()),
          .efforts_by_law = Eigen::VectorXd::Zero(efforts())};
}

void AppliedLoads::evaluate(double t, const Configuration& x,
                            const std::vector<Twist>& twists,
                            const double* internal, LoadState& state) const {
  forces_.evaluate(t, x, twists, internal, state.forces);
  for (std::size_t i = 1; i < masses_.size(); ++i) {
    state.wrenches[i].v = masses_[i] * gravity_;
    state.wrenches[i].w.setZero();
  }
  take_efforts(state);
  forces_.add_to(state.forces, state.wrenches);
}

void AppliedLoads::hold_tangents(double t, const Configuration& x,
                                 const std::vector<Twist>& twists,
                                 const double* internal, LoadState& state) {
  forces_.evaluate(t, x, twists, internal, state.forces);
  take_efforts(state);
  forces_.hold_tangents(state.forces, internal);
}

/// Notes what laws say, lets given efforts act.
void AppliedLoads::take_efforts(LoadState& state) const {
  for (std::size_t i = 0; i < stiff_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    ElementResponse& e = state.forces.elements[stiff_[i]];
    state.efforts_by_law[at] = e.effort;
    if (given_ != nullptr) e.give_effort((*given_)[at]);
  }
}

}  // namespace clevis::mechanism
