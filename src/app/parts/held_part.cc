#include "app/parts/held_part.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "elasticity/solid/open_reactions.h"
#include "loads/history/balance.h"
#include "loads/parts/case_loads.h"

namespace clevis::app {
namespace {

using Patterns = std::vector<std::vector<loads::Wrench>>;

/// Of the pins to all seats, of which they are the last, in multiples of
/// `unit`.
Patterns on_all_seats(const Patterns& pins, std::size_t seats, double unit) {
  Patterns all;
  for (const auto& pattern : pins) {
    auto& wrenches = all.emplace_back(seats);
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      loads::Wrench& wrench = wrenches[seats - pattern.size() + i];
      wrench = {.force = unit * pattern[i].force,
                .moment = unit * pattern[i].moment};
    }
  }
  return all;
}

}  // namespace

loads::SharedPins held_loads(const LoadedPart& part,
                             const part::LoadCaseDefinition& load_case) {
  loads::LoadHistory history =
      loads::case_loads(part.definition, load_case, part.groups, part.mass);
  if (load_case.held_by_pin.size() < 2) return {std::move(history), {}};
  const double size = loads::part_size(part.groups, part.mass);
  const auto pins =
      loads::pins_in(load_case.held_by_pin, part.groups, size,
                     part.definition.place + ": part " + part.definition.name);
  const double unit =
      loads::imbalance(history, history.instants.front(), part.mass, size)
          .force_scale;
  if (unit == 0.0) return {std::move(history), {}};
  const auto [A, b] = elasticity::pattern_energy(
      part.mesh, part.definition.material, history,
      on_all_seats(pins.open(), history.seats.size(), unit),
      part.definition.name);
  return loads::share(pins, history, part.mass, size, unit, A, b);
}

}  // namespace clevis::app
