#include "mechanism/dynamic_motion/dynamic_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/dynamic_motion/dynamic_run.h"
#include "mechanism/sampling/law_times.h"
#include "mechanism/sampling/slide_times.h"

namespace clevis::mechanism {
namespace {

/// @throws Error K006 if a body is so light beside another that accelerations
///   by it have no digit left.
void refuse_massless(const MechanismDefinition& definition) {
  constexpr double kLightest = 1e-12;
  double heaviest = 0.0;
  for (const BodyDefinition& body : definition.bodies) {
    heaviest = std::max(heaviest, body.mass_properties.mass);
  }
  for (const BodyDefinition& body : definition.bodies) {
    const double mass = body.mass_properties.mass;
    if (mass >= kLightest * heaviest) continue;
    throw Error("K006", body.place,
                fmt::format("body {} has {:.3g} kg beside one of {:.3g} kg: "
                            "massless, for double precision",
                            body.name, mass, heaviest),
                "Give the body its mass, or replace a link between two joints "
                "by a joint of type \"distance\".");
  }
}

/// Instants within the hardest impacts, whose loads a part may feel at no other
/// time [s].
std::vector<double> impact_times(std::vector<Impact> impacts, double duration) {
  constexpr std::size_t kMost = 60;
  constexpr double kLeast = 0.01;  // of the hardest
  constexpr int kParts = 4;        // of its rise, and of its fall
  constexpr double kLast = 1e-5;   // of the duration
  std::ranges::stable_sort(impacts, std::ranges::greater{},
                           &Impact::peak_force);
  std::vector<double> times;
  for (std::size_t i = 0; i < std::min(kMost, impacts.size()); ++i) {
    const Impact& impact = impacts[i];
    if (!(impact.peak_force > kLeast * impacts.front().peak_force)) break;
    // What comes to rest presses hardest just before the end.
    if (impact.peak_at > (1.0 - kLast) * duration) continue;
    const double end = impact.t + impact.duration.value_or(0.0);
    for (int k = 1; k <= kParts; ++k) {
      const double share = double(k) / kParts;
      times.push_back(std::lerp(impact.t, impact.peak_at, share));
      if (k == kParts || end <= impact.peak_at) continue;
      times.push_back(std::lerp(impact.peak_at, end, share));
    }
  }
  return times;
}

}  // namespace

Motion integrate_motion(const MechanismDefinition& definition,
                        const SimulationSettings& settings) {
  refuse_massless(definition);
  TimeLimit limit(settings.max_time, settings.duration,
                  settings.at_peaks ? 2 : 1);
  if (!settings.at_peaks) return DynamicRun(definition, settings, limit).run();
  // the same run twice: the first tells when loads are largest
  DynamicRun first(definition, settings, limit);
  first.watch();
  const Motion found = first.run();
  limit.end_pass();
  std::vector<double> others = first.peaks().times();
  BesideChangePoints beside{{}, settings.duration / (settings.instants - 1)};
  for (const ChangePoint& point : found.change_points) {
    beside.times.push_back(point.t);
  }
  for (const auto& more :
       {impact_times(found.impacts, settings.duration),
        slide_times(definition, settings.slides, found.instants)}) {
    others.insert(others.end(), more.begin(), more.end());
  }
  std::erase_if(others, [&](double t) {
    return beside.contains(t);
  });
  const LawTimes laws = law_times(definition, settings.duration, 0.0);
  const auto at_laws = instants_of_laws(laws, settings.duration);
  others.insert(others.end(), at_laws.begin(), at_laws.end());
  DynamicRun second(definition, settings, limit, others);
  second.refine(first.peaks().largest(), beside);
  Motion motion = second.run();
  motion.bends = bends_of_laws(laws);
  return motion;
}

}  // namespace clevis::mechanism
