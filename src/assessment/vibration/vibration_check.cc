#include "assessment/vibration/vibration_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "assessment/pace/load_pace.h"
#include "assessment/stretches/held_stretches.h"
#include "assessment/verdict/governing_peak.h"
#include "assessment/vibration/duration_ratio.h"
#include "assessment/vibration/moved_frequencies.h"
#include "assessment/vibration/stretch_vibration.h"
#include "base/values/stopwatch.h"
#include "loads/history/motion_instants.h"

namespace clevis::assessment {
namespace {

double change(double from, double to) {
  return std::abs(from / to - 1.0);
}

/// Whether the checked peak is one of the motion, not of a case.
bool is_of_motion(const PeakStress& peak, const LoadSet& set) {
  return std::ranges::any_of(set.history.instants, [&](const auto& instant) {
    return instant.label == peak.label && instant.time == peak.instant;
  });
}

/// Whether other loads than those of one motion deflect the part, too.
bool has_other_loads(const PartJob& job, const PartResult& result) {
  return !job.part.cases.empty() || job.load_sets.size() > 1 ||
         !result.impacts.empty();
}

/// Puts the dynamic deflection in place of that at rest; beside other loads
/// only if it is larger. Its band has the error of both.
/// @param swept  see HeldStretch.
void deflect(bool beside_others, const VibrationResult& found, double swept,
             PartResult& result) {
  if (beside_others && found.deflection <= result.deflection) return;
  const double still = result.deflection > 0.0
                           ? result.deflection_high / result.deflection - 1.0
                           : 0.0;
  const double at_rest = result.deflection;
  const double swung = swept > 0.0 ? std::min(found.deflection, swept * at_rest)
                                   : found.deflection;
  const double most = std::max(at_rest, swung);
  const double error = (still + found.error()) * most;
  result.deflection = most;
  result.deflection_low = std::max(0.0, most - error);
  result.deflection_high = std::max(most, swept * at_rest) + error;
}

/// At rest, by the degree of the check: the largest of a load set's motion that
/// does not hold the part's peak; nothing where zones are left out of that.
std::optional<double> largest_of(const std::vector<InstantRow>& rows,
                                 std::size_t set, const LoadSet& given,
                                 const PartResult& result) {
  if (&judged_peak(result) != &result.peak) return std::nullopt;
  auto left = loads::motion_length(given.history);  // cases stand behind it
  double largest = 0.0;
  for (const InstantRow& row : rows) {
    if (row.load_set != set || left == 0) continue;
    largest = std::max(largest, row.peak);
    --left;
  }
  if (!(largest > 0.0)) return std::nullopt;
  return largest;
}

/// Puts the dynamic peak on the check's, or on that of its own loads where
/// others stress the part more at rest.
/// @param swept  see HeldStretch. @pre `found` has a ratio.
void judge_vibration(const LoadSet& set, std::optional<double> largest,
                     double swept, const PartResult& result,
                     VibrationResult& found) {
  const PeakStress& still = judged_peak(result);
  const double low = still.band_low / still.value;
  const double high = still.band_high / still.value;
  double error = found.error();
  const bool of_motion = is_of_motion(still, set);
  if (of_motion) {
    found.peak = *found.ratio * still.value;
  } else {
    // Bands are of the place of the part's peak: its own may be wider.
    constexpr double kOfChange = 0.25;
    error +=
        largest ? kOfChange * change(found.still, *largest) : found.still_error;
    found.peak = *found.ratio * largest.value_or(found.still);
  }
  found.band_low = std::max(0.0, (low - error) * found.peak);
  found.band_high = (high + error) * found.peak;
  if (swept > 0.0) {
    // Held at one place it may swing farther than any that pass.
    const double at_rest = found.peak / *found.ratio;
    found.ratio = std::min(*found.ratio, swept);
    found.peak = *found.ratio * at_rest;
    found.band_low = std::max(0.0, (low - error) * at_rest);
    found.band_high = (high + error) * swept * at_rest;
    found.model += fmt::format(
        "; slides pass where loads excite it, to {:.3g} times at rest at most",
        swept);
  }
  found.governs = of_motion || found.band_high > still.value;
}

/// Why nothing is known of a part's vibration behind a time; empty: all is, or
/// loads are slow there too.
/// @param first  period [s].
std::string not_followed(const PartJob& job, const LoadSet& given,
                         const VibrationTimes& times, double first) {
  const double until = given.history.followed_until;
  LoadSet sparse = given;
  sparse.history.repeats.clear();
  sparse = motion_loads(sparse);
  if (sparse.history.instants.empty() ||
      until >= sparse.history.instants.back().time) {
    return {};
  }
  if (times.driven.empty() &&
      is_slow(job, sparse, load_components(job, sparse))) {
    return {};
  }
  // Steps that follow a sine are a seventh of its period and less.
  constexpr double kSlow = 10.0;
  if (given.history.step_behind > kSlow * first) return {};
  return fmt::format(
      "loads are followed up to t = {:.6g} s, behind it they change too often: "
      "take a shorter duration, or more `instants`",
      until);
}

/// Bodies of next to no mass that forces hang on, or laws of any size, may take
/// the numbers out of their range: then nothing is known.
void tell_overflow(VibrationResult& found) {
  if (!found.ratio || std::isfinite(*found.ratio + found.error() +
                                    found.still_error + found.deflection)) {
    return;
  }
  found = {};
  found.failure =
      "its numbers overflow: see whether a body beside the part has next to no "
      "mass, and seat what acts on it on the part itself";
}

/// @param at_rest  largest stress of its loads [Pa]. @param deflection  that at
///   rest [m].
VibrationResult of_followed(const TravellingVibration& followed, double at_rest,
                            double deflection, const LoadSet& set) {
  constexpr double kOfFewShapes = 0.1;  // their stress at rest
  constexpr double kSame = 0.25;
  const auto& instants = set.history.instants;
  VibrationResult found;
  found.ratio = std::max(1.0, followed.stress);
  found.still = followed.still;
  found.still_error = kOfFewShapes;
  found.shape_error = followed.error;
  if (change(followed.still, at_rest) > kSame) {
    // The peak at rest is local, as beside a pin, which few shapes do not have:
    // what is not at rest may come on top of it, or stand elsewhere.
    const double least =
        std::max(1.0, followed.stress * followed.still / at_rest);
    const double most = std::max(least, 1.0 + followed.beyond_rest / at_rest);
    found.ratio = 0.5 * (least + most);
    found.shape_error += 0.5 * (most - least) / *found.ratio;
  }
  found.at = followed.at;
  found.group = followed.group;
  found.time = followed.time;
  found.from = instants.front().time;
  found.to = instants.back().time;
  found.deflection = std::max(1.0, followed.deflection) * deflection;
  found.model = "shapes that slides and neighbours hold from time to time";
  found.shapes = followed.shapes;
  found.lowest_frequency = followed.lowest;
  found.highest_frequency = followed.highest;
  return found;
}

/// Of one load set; nothing where its loads are followed at rest.
/// @param swept  the largest of its stretches.
std::optional<VibrationResult> vibration_of(const PartJob& job, std::size_t s,
                                            const std::vector<InstantRow>& rows,
                                            HeldMotions& held,
                                            PartResult& result, double& swept) {
  const LoadSet& given = job.load_sets[s];
  VibrationTimes times{judge_load_pace(job, s, held, result), {}};
  if (!(judged_peak(result).value > 0.0)) return {};
  VibrationResult found;
  std::string unknown =
      not_followed(job, given, times,
                   result.first_period.value_or(softest_period(job, given)));
  if (unknown.empty() && result.first_period) {
    unknown = not_known_spinning(job, given, *result.first_period);
  }
  if (times.driven.empty()) {
    if (unknown.empty()) return {};
    found.not_followed = unknown;
    return found;
  }
  Stopwatch watch;
  auto held_stretches = held.stretches(s, times.driven);
  if (const auto followed = held.followed(s, held_stretches)) {
    const double at_rest =
        largest_of(rows, s, given, result).value_or(judged_peak(result).value);
    found = of_followed(*followed, at_rest, result.deflection, held.loads(s));
    tell_overflow(found);
    found.not_followed = unknown;
    found.seconds = watch.lap();
    return found;
  }
  PartJob moving = job;
  moving.load_sets = {held.loads(s)};
  const loads::LoadHistory& history = moving.load_sets.front().history;
  std::vector<Stretch> stretches;
  for (HeldStretch& stretch : held_stretches) {
    VibrationTimes there{std::move(stretch.windows), {}};
    there.is_stretch = held_stretches.size() > 1;
    there.swing = swing_windows(there.driven, held.first_period(s),
                                job.part.damping, history.instants.back().time);
    swept = std::max(swept, stretch.swept);
    stretches.push_back({stretch.hold_time, std::move(there)});
  }
  found = largest_vibration(moving, stretches);
  tell_overflow(found);
  found.not_followed = unknown;
  found.seconds = watch.lap();
  return found;
}

}  // namespace

void check_vibration(const PartJob& job, const std::vector<InstantRow>& rows,
                     HeldMotions& held, PartResult& result) {
  std::optional<VibrationResult> most;
  const double at_rest = result.deflection;
  double seconds = 0.0;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const LoadSet& given = job.load_sets[s];
    double swept = 0.0;
    auto found = vibration_of(job, s, rows, held, result, swept);
    if (!found) continue;
    seconds += found->seconds;
    if (found->ratio) {
      judge_vibration(followed_loads(given), largest_of(rows, s, given, result),
                      swept, result, *found);
      deflect(has_other_loads(job, result), *found, swept, result);
      result.swings.resize(job.load_sets.size());
      result.swings[s] = {
          .stress = std::max(1.0, *found->ratio),
          .deflection =
              at_rest > 0.0 ? std::max(1.0, found->deflection / at_rest) : 1.0};
    }
    // One that could not be computed must be told.
    const bool is_more =
        !most || !found->is_whole() ||
        (most->is_whole() && found->band_high > most->band_high);
    if (is_more) most = std::move(found);
  }
  if (!most) return;
  most->seconds = seconds;
  if (most->governs) {
    result.safety_factor = job.part.material.yield_strength / most->peak;
  }
  result.vibration = std::move(*most);
  refer_to_vibration(job, result);
}

}  // namespace clevis::assessment
