#include "mechanism/equations_of_motion/contact_inertia.h"

#include <cmath>
#include <limits>

#include "base/index.h"

namespace clevis::mechanism {

ContactInertia contact_inertia(ForwardDynamics& dynamics, std::size_t element,
                               int end) {
  const ActingElement& e = dynamics.forces().element(element);
  const PlacedJoint::Levers levers = e.apart(end);
  const Eigen::VectorXd& acceleration = dynamics.accelerations();
  Eigen::VectorXd on_a = Eigen::VectorXd::Zero(acceleration.size());
  Eigen::VectorXd on_b = on_a, response = on_a;
  dynamics.put_lever(e.line.a, levers.a, on_a);
  dynamics.put_lever(e.line.b, levers.b, on_b);
  const Eigen::VectorXd both = on_a + on_b;
  const double opening = both.dot(acceleration) +
                         e.apart_bias(end, dynamics.twists()[index(e.line.a)],
                                      dynamics.twists()[index(e.line.b)]);
  const double free_a = dynamics.free_response(e.line.a, levers.a);
  const double free_b = dynamics.free_response(e.line.b, levers.b);
  const auto mass = [&](const Eigen::VectorXd& force, double free) {
    constexpr double kHeld = 1e-10;  // round-off of what cannot give way
    dynamics.respond(force, response);
    const double way = force.dot(response);
    return way > kHeld * free ? 1.0 / way
                              : std::numeric_limits<double>::infinity();
  };
  ContactInertia found;
  found.mass_a = mass(on_a, free_a);
  found.mass_b = mass(on_b, free_b);
  found.mass = mass(both, free_a + free_b);
  if (std::isfinite(found.mass)) {
    const double own = e.modes[index(end)] == 1 ? e.unbounded[index(end)] : 0.0;
    found.force = own - found.mass * opening;
  }
  return found;
}

}  // namespace clevis::mechanism
