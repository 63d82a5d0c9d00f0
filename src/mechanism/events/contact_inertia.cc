#include "mechanism/events/contact_inertia.h"

#include <cmath>
#include <limits>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

/// A unit force apart on either body, by unknown.
struct Push {
  PlacedJoint::Levers levers;
  VectorXd on_a, on_b;
};

Push push_apart(EquationsOfMotion& equations, std::size_t element, int end) {
  const ActingElement& e = equations.forces().element(element);
  const VectorXd none =
      VectorXd::Zero(equations.solution().accelerations.size());
  Push push{
      .levers = e.apart(end, equations.state().loads.forces.elements[element]),
      .on_a = none,
      .on_b = none};
  equations.layout().add_lever(e.line.a, push.levers.a, push.on_a);
  equations.layout().add_lever(e.line.b, push.levers.b, push.on_b);
  return push;
}

double opening_by(const Push& push, EquationsOfMotion& equations,
                  std::size_t element, int end) {
  const MechanismState& state = equations.state();
  const ActingElement& e = equations.forces().element(element);
  return (push.on_a + push.on_b).dot(equations.solution().accelerations) +
         e.apart_bias(end, state.loads.forces.elements[element],
                      state.twists[index(e.line.a)],
                      state.twists[index(e.line.b)]);
}

}  // namespace

double opening_acceleration(EquationsOfMotion& equations, std::size_t element,
                            int end) {
  return opening_by(push_apart(equations, element, end), equations, element,
                    end);
}

ContactInertia contact_inertia(EquationsOfMotion& equations,
                               std::size_t element, int end) {
  const MechanismState& state = equations.state();
  const ActingElement& e = equations.forces().element(element);
  const ElementResponse& acting = state.loads.forces.elements[element];
  const Push push = push_apart(equations, element, end);
  const double opening = opening_by(push, equations, element, end);
  const auto free_response = [&](int slot, const SpatialForce& lever) {
    return equations.inertias().free_response(slot, state.x[index(slot)].R,
                                              lever);
  };
  const double free_a = free_response(e.line.a, push.levers.a);
  const double free_b = free_response(e.line.b, push.levers.b);
  const auto mass = [&](const VectorXd& force, double free) {
    constexpr double kHeld = 1e-10;  // round-off of what cannot give way
    const double way = force.dot(equations.respond(force).accelerations);
    return way > kHeld * free ? 1.0 / way
                              : std::numeric_limits<double>::infinity();
  };
  ContactInertia found;
  found.mass_a = mass(push.on_a, free_a);
  found.mass_b = mass(push.on_b, free_b);
  found.mass = mass(push.on_a + push.on_b, free_a + free_b);
  if (std::isfinite(found.mass)) {
    const double own =
        e.modes[index(end)] == 1 ? acting.unbounded[index(end)] : 0.0;
    found.force = own - found.mass * opening;
  }
  return found;
}

}  // namespace clevis::mechanism
