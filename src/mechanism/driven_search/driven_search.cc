#include "mechanism/driven_search/driven_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "mechanism/driven_loads/load_instants.h"
#include "mechanism/driven_loads/load_trajectory.h"
#include "mechanism/driven_search/driven_events.h"
#include "mechanism/sampling/driven_sampling.h"

namespace clevis::mechanism {
namespace {

// Looks beside the instants; each takes some kilobytes.
constexpr std::size_t kMostLooks = 50'000;
// Instants that stress analysis takes in seconds.
constexpr std::size_t kMostAdded = 4000;
// Looks over the duration where nothing else asks for any.
constexpr int kLeastLooks = 33;

}  // namespace

DrivenSearch::DrivenSearch(const MechanismDefinition& definition,
                           const SimulationSettings& settings,
                           DrivenMotion& motion)
    : definition_(definition),
      settings_(settings),
      most_looks_(kMostLooks + static_cast<std::size_t>(settings.instants)),
      uniform_(uniform_times(settings)),
      laws_(law_times(definition, settings.duration,
                      static_cast<double>(kMostLooks))),
      trajectory_(definition, settings, motion) {}

/// Marks the looks at and beside the times that laws name.
void DrivenSearch::mark_laws() {
  const double side = 0.5 * kSides * settings_.duration;
  const double apart = kApart * settings_.duration;
  const auto is_one_of = [apart](const std::vector<double>& times, double t) {
    const auto next = std::ranges::lower_bound(times, t - apart);
    return next != times.end() && *next <= t + apart;
  };
  auto& looks = trajectory_.looks();
  auto step = laws_.steps.begin();
  for (auto i = looks.begin(); i != looks.end(); ++i) {
    i->bends =
        is_one_of(laws_.breakpoints, i->t) || is_one_of(laws_.knots, i->t);
    while (step != laws_.steps.end() && *step + 1.5 * side < i->t) ++step;
    if (step == laws_.steps.end() || std::next(i) == looks.end()) continue;
    // the last look before a step to the first behind it
    i->breaks = i->t >= *step - 1.5 * side && i->t < *step + 0.5 * side;
  }
}

/// Rigid reactions have no bound there: no instant is the largest.
bool DrivenSearch::beside_change_point(double t) const {
  const double spacing = settings_.duration / (settings_.instants - 1);
  return std::ranges::any_of(trajectory_.change_points(),
                             [&](const auto& point) {
                               return std::abs(point.t - t) <= 2.0 * spacing;
                             });
}

std::vector<Configuration> DrivenSearch::positions_at(
    const std::vector<double>& times) {
  std::vector<Configuration> positions;
  if (!trajectory_.change_points().empty()) return positions;
  auto look = trajectory_.looks().begin();
  for (const double t : times) {
    while (look != trajectory_.looks().end() && look->t < t) ++look;
    if (look == trajectory_.looks().end() || look->t != t) return {};
    positions.push_back(look->x);
  }
  return positions;
}

DrivenSearch::Found DrivenSearch::run() {
  const double duration = settings_.duration;
  std::vector<double> instants = uniform_;
  add_times(instants_of_laws(laws_, duration), duration, instants);
  if (!settings_.slides.empty()) {  // where they turn back
    for (const auto* turns : {&laws_.knots, &laws_.looks}) {
      if (turns->size() <= kMostAdded) add_times(*turns, duration, instants);
    }
  }
  std::vector<double> times = instants;
  for (const auto* more : {&laws_.breakpoints, &laws_.knots, &laws_.looks}) {
    add_times(*more, duration, times);
  }
  SimulationSettings least = settings_;
  least.instants = kLeastLooks;
  if (settings_.instants < kLeastLooks) {
    add_times(uniform_times(least), duration, times);
  }
  bool enough = trajectory_.walk(times, most_looks_) && laws_.all;
  for (auto& look : trajectory_.looks()) {
    look.is_instant = std::ranges::binary_search(instants, look.t);
  }
  mark_laws();
  DrivenEvents events(trajectory_);
  enough = events.find(most_looks_) && enough;
  LoadScales scales(trajectory_, [this](double t) {
    return beside_change_point(t);
  });
  LoadTrajectory loads(scales);
  enough = loads.refine(most_looks_) && enough;
  LoadInstants chosen(scales);
  chosen.choose(kMostAdded);

  Found found;
  found.search = {.looks = trajectory_.count(),
                  .ended = !enough,
                  .ended_at = enough ? duration : loads.ended_at(),
                  .bodies = chosen.unseen()};
  found.followed_until = chosen.follow(kMostAdded);
  for (const auto& look : trajectory_.looks()) {
    if (look.is_instant || look.follows) {
      instants.push_back(look.t);
      if (look.bends) found.bends.push_back(look.t);
    }
    if (look.follows && !look.is_instant) found.repeats.push_back(look.t);
  }
  std::ranges::sort(instants);
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
  found.positions = positions_at(instants);
  found.times = std::move(instants);
  found.events = events.events();
  if (!enough) {  // nothing is known of what was not looked at
    for (double& unseen : found.search.bodies) unseen = std::max(unseen, 1.0);
  }
  return found;
}

}  // namespace clevis::mechanism
