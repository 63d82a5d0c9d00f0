#include "assessment/notes/case_notes.h"

#include <algorithm>

#include <fmt/format.h>

#include "loads/history/balance.h"
#include "loads/holds/holding_groups.h"
#include "loads/parts/held_pins.h"

namespace clevis::assessment {
namespace {

void note_relief(const PartJob& job, const LoadSet& set,
                 const loads::InstantLoad& instant, double size,
                 PartResult& result) {
  const loads::Wrench& rest = instant.relief;
  const double force = rest.force.norm(), moment = rest.moment.norm();
  if (force == 0.0 && moment == 0.0) return;
  loads::Imbalance taken =
      loads::imbalance(set.history, instant, job.mass, size);
  taken.left = rest;
  result.notes.push_back(fmt::format(
      "case {}: its loads leave {:.4g} N and, about the part's origin, {:.4g} "
      "N m, {:.2g} % of the load: inertia takes it up",
      instant.label, force, moment, 100.0 * taken.relative()));
}

void note_pins(const PartJob& job, const part::LoadCaseDefinition& load_case,
               const LoadSet& set, const loads::InstantLoad& instant,
               double size, PartResult& result) {
  const auto& bores = load_case.held_by_pin;
  if (bores.empty()) return;
  const auto pins =
      loads::pins_in(bores, job.groups, size, "part " + job.part.name);
  for (std::size_t i = 0; i < bores.size(); ++i) {
    const auto seat =
        std::ranges::find(set.history.seats, bores[i], &loads::Seat::group);
    const auto& wrench = instant.wrenches[static_cast<std::size_t>(
        seat - set.history.seats.begin())];
    result.pin_reactions.push_back({load_case.name, bores[i], wrench.force,
                                    wrench.moment, pins.is_unique(i)});
  }
}

/// Of a free part nobody knows which of its pins hold it.
void note_reference(const PartJob& job, const LoadSet& set,
                    PartResult& result) {
  const auto& instants = set.history.instants;
  const bool is_case = !instants.empty() && instants.front().is_case;
  if (!job.part.limits.deflection || !is_case || set.history.hold ||
      !set.fixed.empty() || !set.foundations.empty()) {
    return;
  }
  const auto holds = loads::holding_groups(set.history);
  if (holds.size() < 2) return;  // three pins and more have three pairs
  result.notes.push_back(fmt::format(
      "deflection is relative to the pins in {} and {}, the first by name: say "
      "which hold the part by `held_by_pin`",
      holds.front().front(), holds.front().back()));
}

}  // namespace

void note_cases(const PartJob& job, PartResult& result) {
  for (const LoadSet& set : job.load_sets) note_reference(job, set, result);
  const double size = loads::part_size(job.groups, job.mass);
  for (const auto& load_case : job.part.cases) {
    for (const LoadSet& set : job.load_sets) {
      const auto& instants = set.history.instants;
      const auto instant = std::ranges::find(instants, load_case.name,
                                             &loads::InstantLoad::label);
      if (instant == instants.end()) continue;
      note_relief(job, set, *instant, size, result);
      note_pins(job, load_case, set, *instant, size, result);
    }
  }
}

}  // namespace clevis::assessment
