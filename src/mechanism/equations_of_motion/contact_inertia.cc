#include <cmath>
#include <limits>

#include "mechanism/equations_of_motion/forward_dynamics.h"

namespace clevis::mechanism {
void ForwardDynamics::evaluate_forces(double t, const Eigen::VectorXd& y) {
  place(t, y);
  forces_.evaluate(t, x_, twists_, y.data() + internal_index());
}

void ForwardDynamics::put_lever(int slot, const Twist& lever,
                                Eigen::VectorXd& force) const {
  if (slot == 0) return;
  if (planar_) {
    const Eigen::Index at = 3 * (slot - 1);
    force.segment<2>(at) += lever.v.head<2>();
    force[at + 2] += lever.w.z() / length_;
  } else {
    const Eigen::Index at = 6 * (slot - 1);
    force.segment<3>(at) += lever.v;
    force.segment<3>(at + 3) += lever.w / length_;
  }
}

double ForwardDynamics::free_response(int slot, const Twist& lever) const {
  if (slot == 0) return 0.0;
  const auto at = static_cast<std::size_t>(slot);
  const Eigen::Vector3d turn =
      bodies_[at].turn_factor.transpose() * x_[at].R.transpose() * lever.w;
  return lever.v.squaredNorm() / applied_.mass(at) +
         turn.squaredNorm() / (length_ * length_);
}

ContactInertia ForwardDynamics::contact_inertia(std::size_t element, int end) {
  const ActingElement& e = forces_.element(element);
  const PlacedJoint::Levers levers = e.apart(end);
  Eigen::VectorXd on_a = Eigen::VectorXd::Zero(columns_);
  Eigen::VectorXd on_b = on_a, response = on_a;
  Eigen::VectorXd none = Eigen::VectorXd::Zero(gamma_.size());
  Eigen::VectorXd multipliers = none;
  put_lever(e.line.a, levers.a, on_a);
  put_lever(e.line.b, levers.b, on_b);
  const Eigen::VectorXd both = on_a + on_b;
  const double opening =
      both.dot(acceleration_) +
      e.apart_bias(end, twists_[static_cast<std::size_t>(e.line.a)],
                   twists_[static_cast<std::size_t>(e.line.b)]);
  const double free_a = free_response(e.line.a, levers.a);
  const double free_b = free_response(e.line.b, levers.b);
  const auto mass = [&](const Eigen::VectorXd& force, double free) {
    constexpr double kHeld = 1e-10;  // round-off of what cannot give way
    mass_.accelerate(none, force, response, multipliers);
    const double way = force.dot(response);
    return way > kHeld * free ? 1.0 / way
                              : std::numeric_limits<double>::infinity();
  };
  ContactInertia found;
  found.mass_a = mass(on_a, free_a);
  found.mass_b = mass(on_b, free_b);
  found.mass = mass(both, free_a + free_b);
  if (std::isfinite(found.mass)) {
    const auto at = static_cast<std::size_t>(end);
    const double own = e.modes[at] == 1 ? e.unbounded[at] : 0.0;
    found.force = own - found.mass * opening;
  }
  return found;
}

}  // namespace clevis::mechanism
