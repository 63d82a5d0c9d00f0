#include "mechanism/forces/applied_loads.h"

namespace clevis::mechanism {

using Eigen::Vector3d;
using Eigen::VectorXd;

AppliedLoads::AppliedLoads(const MechanismDefinition& definition,
                           const SolvingFrame& frame)
    : forces_(definition, frame),
      masses_(frame.placement.size()),
      gravity_(frame.R_WP.transpose() * definition.gravity_W),
      wrenches_(frame.placement.size()),
      stiff_(forces_.with_smooth_efforts()),
      by_law_(VectorXd::Zero(efforts())) {
  for (std::size_t i = 1; i < masses_.size(); ++i) {
    masses_[i] = definition.bodies[i - 1].mass_properties.mass;
  }
}

void AppliedLoads::evaluate(double t, const Configuration& x,
                            const std::vector<Twist>& twists,
                            const double* internal) {
  forces_.evaluate(t, x, twists, internal);
  for (std::size_t i = 1; i < wrenches_.size(); ++i) {
    wrenches_[i].v = masses_[i] * gravity_;
    wrenches_[i].w.setZero();
  }
  take_efforts();
  forces_.add_to(wrenches_);
}

double AppliedLoads::power(const std::vector<Twist>& twists) const {
  double power = 0.0;
  for (std::size_t i = 1; i < wrenches_.size(); ++i) {
    power += wrenches_[i].v.dot(twists[i].v) + wrenches_[i].w.dot(twists[i].w);
  }
  return power;
}

void AppliedLoads::hold_tangents(double t, const Configuration& x,
                                 const std::vector<Twist>& twists,
                                 const double* internal) {
  forces_.evaluate(t, x, twists, internal);
  take_efforts();
  forces_.hold_tangents(internal);
}

/// Notes what laws say, lets given efforts act.
void AppliedLoads::take_efforts() {
  for (std::size_t i = 0; i < stiff_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    by_law_[at] = forces_.element(stiff_[i]).effort;
    if (given_ != nullptr) forces_.set_effort(stiff_[i], (*given_)[at]);
  }
}

}  // namespace clevis::mechanism
