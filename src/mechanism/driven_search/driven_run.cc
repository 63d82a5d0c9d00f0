#include "mechanism/driven_search/driven_run.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "mechanism/driven_motion/driven_motion.h"
#include "mechanism/driven_search/driven_search.h"
#include "mechanism/forces/line_motion.h"
#include "mechanism/sampling/driven_sampling.h"
#include "mechanism/sampling/slide_times.h"

namespace clevis::mechanism {
namespace {

/// Takes the instants at some times out of a motion.
void set_repeats_apart(const std::vector<double>& times, Motion& motion) {
  if (times.empty()) return;
  const auto repeats =
      std::ranges::stable_partition(motion.instants, [&](const Instant& at) {
        return !std::ranges::binary_search(times, at.t);
      });
  motion.repeats.assign(std::make_move_iterator(repeats.begin()),
                        std::make_move_iterator(repeats.end()));
  motion.instants.erase(repeats.begin(), repeats.end());
}

}  // namespace

Motion run_driven(const MechanismDefinition& definition,
                  const SimulationSettings& settings) {
  DrivenMotion driven(definition, settings);
  if (!settings.at_peaks) return driven.run_at(uniform_times(settings));
  DrivenInstants& instants = driven.instants();
  const std::vector<double> start = instants.line_angles();
  DrivenSearch::Found found = DrivenSearch(definition, settings, driven).run();
  instants.set_line_angles(start, 0.0);
  // Turns are counted along the way.
  Motion motion = found.positions.empty() || counts_turns(instants.forces())
                      ? driven.run_at(found.times)
                      : driven.run_through(found.times, found.positions);
  std::vector<double> times =
      slide_times(definition, settings.slides, motion.instants);
  if (!times.empty()) {
    add_times(found.times, settings.duration, times);
    instants.set_line_angles(start, 0.0);
    motion = driven.run_at(times);
  }
  set_repeats_apart(found.repeats, motion);
  motion.bends = std::move(found.bends);
  motion.events = std::move(found.events);
  motion.followed_until = found.followed_until;
  motion.search = std::move(found.search);
  return motion;
}

}  // namespace clevis::mechanism
