#include "loads/holds/resting_contacts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/LU>

#include "mechanism/element_base/acting_element.h"

namespace clevis::loads {
namespace {

using Instants = std::vector<const mechanism::Instant*>;

/// Of a unit effort on one body that nothing else holds, 1/m [1/kg].
double mobility(const mechanism::Neighbours& neighbours,
                const mechanism::Configuration& x, int slot,
                const mechanism::SpatialForce& lever) {
  if (slot == 0) return 0.0;
  const auto at = static_cast<std::size_t>(slot);
  const auto& mass = neighbours.definition().bodies[at - 1].mass_properties;
  const Eigen::Vector3d turn = x[at].R.transpose() * lever.w;
  return lever.v.squaredNorm() / mass.mass +
         turn.dot(mass.inertia_LCm.inverse() * turn);
}

/// Of two bodies on the stiffness of what presses between them [s]; infinite
/// where it has none.
double period_on(const mechanism::Neighbours& neighbours, std::size_t element,
                 const mechanism::Instant& instant) {
  const auto& acting = *neighbours.elements()[element];
  const auto x = mechanism::configuration_at(neighbours.frame(), instant);
  const auto spring = acting.spring(x, instant.elements[element]);
  if (spring.directions.empty()) return HUGE_VAL;
  const auto& levers = spring.directions.front();
  const double square = spring.stiffness(0, 0) *
                        (mobility(neighbours, x, acting.line.a, levers.a) +
                         mobility(neighbours, x, acting.line.b, levers.b));
  return square > 0.0 ? 2.0 * std::numbers::pi / std::sqrt(square) : HUGE_VAL;
}

/// A time through which an element presses: its first and last instants.
struct Press {
  std::size_t from{}, to{};
};

std::vector<Press> presses(const Instants& instants, std::size_t element) {
  std::vector<Press> found;
  bool pressed = false;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const auto& states = instants[i]->elements;
    const bool now = element < states.size() && states[element].effort != 0.0;
    if (now && !pressed) found.push_back({i, i});
    if (now) found.back().to = i;
    pressed = now;
  }
  return found;
}

}  // namespace

std::vector<std::size_t> bounces(const mechanism::Neighbours& neighbours,
                                 std::size_t element,
                                 const Instants& instants) {
  constexpr double kPeriods = 10.0;
  const auto effort = [element](const mechanism::Instant* instant) {
    return std::abs(instant->elements[element].effort);
  };
  std::vector<std::size_t> found;
  for (const Press& press : presses(instants, element)) {
    const auto from =
        instants.begin() + static_cast<std::ptrdiff_t>(press.from);
    const auto to =
        instants.begin() + static_cast<std::ptrdiff_t>(press.to) + 1;
    const auto hardest = std::max_element(from, to, [&](auto* a, auto* b) {
      return effort(a) < effort(b);
    });
    const double length = instants[press.to]->t - instants[press.from]->t;
    if (length > kPeriods * period_on(neighbours, element, **hardest)) continue;
    for (std::size_t i = press.from; i <= press.to; ++i) found.push_back(i);
  }
  return found;
}

}  // namespace clevis::loads
