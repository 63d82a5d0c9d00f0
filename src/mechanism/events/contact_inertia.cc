#include "mechanism/events/contact_inertia.h"

#include <cmath>
#include <limits>

#include "base/values/index.h"

namespace clevis::mechanism {

ContactInertia contact_inertia(EquationsOfMotion& equations,
                               std::size_t element, int end) {
  const MechanismState& state = equations.state();
  const ActingElement& e = equations.forces().element(element);
  const ElementResponse& acting = state.loads.forces.elements[element];
  const PlacedJoint::Levers levers = e.apart(end, acting);
  const Eigen::VectorXd& acceleration = equations.solution().accelerations;
  Eigen::VectorXd on_a = Eigen::VectorXd::Zero(acceleration.size());
  Eigen::VectorXd on_b = on_a;
  equations.layout().add_lever(e.line.a, levers.a, on_a);
  equations.layout().add_lever(e.line.b, levers.b, on_b);
  const Eigen::VectorXd both = on_a + on_b;
  const double opening =
      both.dot(acceleration) + e.apart_bias(end, acting,
                                            state.twists[index(e.line.a)],
                                            state.twists[index(e.line.b)]);
  const auto free_response = [&](int slot, const SpatialForce& lever) {
    return equations.inertias().free_response(slot, state.x[index(slot)].R,
                                              lever);
  };
  const double free_a = free_response(e.line.a, levers.a);
  const double free_b = free_response(e.line.b, levers.b);
  const auto mass = [&](const Eigen::VectorXd& force, double free) {
    constexpr double kHeld = 1e-10;  // round-off of what cannot give way
    const double way = force.dot(equations.respond(force).accelerations);
    return way > kHeld * free ? 1.0 / way
                              : std::numeric_limits<double>::infinity();
  };
  ContactInertia found;
  found.mass_a = mass(on_a, free_a);
  found.mass_b = mass(on_b, free_b);
  found.mass = mass(both, free_a + free_b);
  if (std::isfinite(found.mass)) {
    const double own =
        e.modes[index(end)] == 1 ? acting.unbounded[index(end)] : 0.0;
    found.force = own - found.mass * opening;
  }
  return found;
}

}  // namespace clevis::mechanism
