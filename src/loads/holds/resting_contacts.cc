#include "loads/holds/resting_contacts.h"

#include <algorithm>
#include <cmath>

#include "mechanism/neighbours/elements_at_rest.h"

namespace clevis::loads {
namespace {

using Instants = std::vector<const mechanism::Instant*>;

/// A time through which an element presses: its first and last instants.
struct Press {
  std::size_t from{}, to{};
};

std::vector<Press> presses(const Instants& instants, std::size_t element) {
  std::vector<Press> found;
  bool pressed = false;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const bool now = !lets_go(*instants[i], element);
    if (now && !pressed) found.push_back({i, i});
    if (now) found.back().to = i;
    pressed = now;
  }
  return found;
}

}  // namespace

bool lets_go(const mechanism::Instant& instant, std::size_t element) {
  return element >= instant.elements.size() ||
         instant.elements[element].effort == 0.0;
}

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
    if (length >
        kPeriods * mechanism::free_period(neighbours, element, **hardest))
      continue;
    for (std::size_t i = press.from; i <= press.to; ++i) found.push_back(i);
  }
  return found;
}

}  // namespace clevis::loads
