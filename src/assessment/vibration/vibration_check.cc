#include "assessment/vibration/vibration_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "assessment/models/level.h"
#include "assessment/models/model_list.h"
#include "assessment/verdict/governing_peak.h"
#include "assessment/vibration/duration_ratio.h"
#include "assessment/vibration/held_stretches.h"
#include "assessment/vibration/load_pace.h"
#include "assessment/vibration/spinning_part.h"
#include "assessment/vibration/vibrating_model.h"
#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "loads/history/motion_instants.h"
#include "stress/displacement/deflection.h"
#include "stress/displacement/held_reference.h"

namespace clevis::assessment {
namespace {

constexpr int kFewest = 16, kMost = 96;  // shapes
constexpr double kSpread =
    0.003;  // of fronts by mesh and shapes, by d'Alembert

double change(double from, double to) {
  return std::abs(from / to - 1.0);
}

/// A stretch of the loads' motion, and how it is looked at.
struct Stretch {
  double hold_time;  ///< LoadHistory::hold_time [s]
  VibrationTimes times;
};

template <int dim>
int highest_degree(const mesh::PartMesh<dim>& mesh) {
  if (mesh.shape == mesh::CellShape::kSimplex) return 2;
  return dim == 2 ? 4 : 3;
}

/// By the degree below.
struct LowVibration {
  int count{};  ///< shapes that suffice
  double ratio{}, still{};
  double shape_error{}, path_error{};  ///< as of VibrationResult
  std::string group{};                 ///< of the peak
  double deflection{};                 ///< as of VibrationResult

  /// The ratio, with the errors that are its own.
  double most() const { return ratio * (1.0 + shape_error + path_error); }
};

/// Largest of an answer over its times [m].
template <int dim>
double deflection_of(const RestingModel<dim>& rest, const Stretch& stretch,
                     VibratingAnswer<dim>& answer) {
  LoadSet set = rest.loads();
  set.history.hold_time = stretch.hold_time;
  if (set.fixed.empty() && set.foundations.empty()) {
    stress::remove_rigid_motion<dim>(answer.basis, reference_hold(set));
  }
  constexpr int kSixth = 6;  // of the times
  return stress::largest_deflection_of_many<dim>(answer.basis, kSixth);
}

/// @param largest  ratio of the stretches before: what is far below it by the
///   fewest shapes is not refined.
template <int dim>
LowVibration vibrate_low(const RestingModel<dim>& rest, const Stretch& stretch,
                         double largest) {
  constexpr double kFar = 0.25, kRough = 1.0;
  LowVibration result{.count = kFewest, .still = rest.peak().value};
  int& count = result.count;
  VibratingModel<dim> low(rest, stretch.hold_time, stretch.times);
  const double settled = 0.3 * rest.job().tolerance;
  auto few = low.answer(count, rest.path(), Fronts::kTaken);
  double before = few.peak.value;
  if (before < kFar * largest * result.still) {
    result.ratio = before / result.still;
    result.shape_error = kRough;
    result.deflection = deflection_of<dim>(rest, stretch, few);
    return result;
  }
  for (;;) {
    count *= 2;
    auto more = low.answer(count, rest.path(), Fronts::kJudged);
    const double moved =
        std::max(change(before, more.peak.value), more.front_error);
    result.shape_error = std::max(kSpread, moved);
    before = more.peak.value;
    const bool is_sharp = more.mesh_spreads_more || more.spread_error < settled;
    if (count >= kMost || more.shapes < count ||
        (moved < settled && is_sharp)) {
      result.group = more.group;
      result.deflection = deflection_of<dim>(rest, stretch, more);
      break;
    }
  }
  result.ratio = result.still > 0.0 ? before / result.still : 0.0;
  result.path_error =
      change(low.answer(count, thinned(rest.path()), Fronts::kTaken).peak.value,
             before) /
      3.0;
  return result;
}

template <int dim>
VibrationResult vibrate_high(const RestingModel<dim>& rest,
                             const Stretch& stretch, const LowVibration& low,
                             std::string_view model) {
  VibrationResult result;
  const double still = rest.peak().value;
  if (!(still > 0.0)) return {};  // the zones are all that is loaded
  const VibrationTimes& times = stretch.times;
  VibratingModel<dim> high(rest, stretch.hold_time, times);
  auto found = high.answer(low.count, rest.path(), Fronts::kJudged);
  result.peak = found.peak.value;
  const double ratio = result.peak / still;
  // The peak at rest may stand where the part is held otherwise.
  result.ratio = times.is_stretch ? std::max(1.0, ratio) : ratio;
  result.path_error = low.path_error;
  result.degree_error = change(low.ratio, ratio);
  result.still = still;
  result.still_error = change(low.still, result.still);
  // The spread is less with more shapes: both tell what these would change.
  result.shape_error = std::max(low.shape_error, found.spread_error);
  result.sampling_error = found.sampling_error;
  result.at = found.at;
  result.group = found.group;
  result.time = found.time;
  result.shapes = found.shapes;
  result.lowest_frequency = found.lowest;
  result.highest_frequency = found.highest;
  result.model = fmt::format("{}, p = {}", model, rest.degree());
  result.deflection = deflection_of<dim>(rest, stretch, found);
  result.from = times.swing.front().from;
  result.to = times.swing.back().to;
  return result;
}

/// Of two stretches: that with the larger peak.
VibrationResult larger_of(VibrationResult a, VibrationResult b) {
  const auto most = [](const VibrationResult& one) {
    return one.ratio ? *one.ratio * (1.0 + one.error()) : 0.0;
  };
  const double deflection = std::max(a.deflection, b.deflection);
  VibrationResult& larger = most(a) > most(b) ? a : b;
  larger.deflection = deflection;
  return std::move(larger);
}

/// Whether what the high degree found of one stretch is more than what it may
/// find of another: that changes with the degree as the first does where both
/// peaks lie on one surface, else by up to a tenth more.
/// @param first  of the stretch that was found.
bool is_covered(const LowVibration& low, const LowVibration& first,
                const VibrationResult& found) {
  if (!found.ratio || !(first.ratio > 0.0)) return false;
  constexpr double kElsewhere = 1.1;
  const bool is_near = !low.group.empty() && low.group == first.group;
  const double grown = std::max(1.0, *found.ratio / first.ratio);
  return low.most() * grown * (is_near ? 1.0 : kElsewhere) <=
         *found.ratio * (1.0 + found.error());
}

/// All stretches by the low degree, which of them may have the largest stress
/// by the high one too: the likeliest first, which covers others.
template <int dim>
VibrationResult vibrate(const PartJob& job, const mesh::PartMesh<dim>& mesh,
                        const LoadSet& set,
                        const std::vector<Stretch>& stretches,
                        std::string_view model) {
  const int degree = highest_degree(mesh);
  std::vector<LowVibration> lows;
  double largest = 0.0, deflection = 0.0;
  {
    const RestingModel<dim> rest(job, mesh, set, degree - 1);
    for (const Stretch& stretch : stretches) {
      lows.push_back(vibrate_low<dim>(rest, stretch, largest));
      largest = std::max(largest, lows.back().ratio);
      deflection = std::max(deflection, lows.back().deflection);
    }
  }
  const RestingModel<dim> rest(job, mesh, set, degree);
  const std::size_t first = static_cast<std::size_t>(
      std::ranges::max_element(lows, {}, &LowVibration::most) - lows.begin());
  VibrationResult found =
      vibrate_high<dim>(rest, stretches[first], lows[first], model);
  const VibrationResult of_first = found;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    if (k == first || is_covered(lows[k], lows[first], of_first)) continue;
    found = larger_of(std::move(found),
                      vibrate_high<dim>(rest, stretches[k], lows[k], model));
  }
  found.deflection = std::max(found.deflection, deflection);
  return found;
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
void deflect(bool beside_others, const VibrationResult& found,
             PartResult& result) {
  if (beside_others && found.deflection <= result.deflection) return;
  const double still = result.deflection > 0.0
                           ? result.deflection_high / result.deflection - 1.0
                           : 0.0;
  const double most = std::max(result.deflection, found.deflection);
  const double error = (still + found.error()) * most;
  result.deflection = most;
  result.deflection_low = std::max(0.0, most - error);
  result.deflection_high = most + error;
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
/// @pre `found` has a ratio.
void judge_vibration(const LoadSet& set, std::optional<double> largest,
                     const PartResult& result, VibrationResult& found) {
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

/// Why a part's vibration is not known as it spins about its length: loads that
/// change in space meet its shapes in space, which turn in its own frame;
/// empty: it is.
/// @param first  period [s].
std::string not_known_spinning(const PartJob& job, const LoadSet& given,
                               double first) {
  const LoadSet motion = followed_loads(given);
  if (!spins_fast(job, motion, first) || stand_in_space(job, motion, first)) {
    return {};
  }
  return fmt::format(
      "it spins about its length at {:.2g} of its first frequency: its shapes "
      "turn in its frame, which is not computed",
      spin_about_length(job, motion) * first / (2.0 * std::numbers::pi));
}

/// Of the job's one load set.
VibrationResult vibrate(const PartJob& job,
                        const std::vector<Stretch>& stretches) {
  VibrationResult found;
  try {
    const PartShape shape(job);
    const Model& model = cheapest_in_time(shape);
    found = std::visit(
        [&]<int dim>(const FeModel<dim>& fe) {
          return vibrate<dim>(job, *fe.mesh, job.load_sets.front(), stretches,
                              model.traits.name);
        },
        model.make(shape, {}));
  } catch (const Error& error) {
    found.failure = fmt::format("{}: {}", error.code(), error.what());
  }
  return found;
}

/// Of one load set; nothing where its loads are followed at rest.
std::optional<VibrationResult> vibration_of(const PartJob& job, std::size_t s,
                                            HeldMotions& held,
                                            PartResult& result) {
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
  PartJob moving = job;
  moving.load_sets = {held.loads(s)};
  const loads::LoadHistory& history = moving.load_sets.front().history;
  std::vector<Stretch> stretches;
  auto held_stretches = held.stretches(s, times.driven);
  for (HeldStretch& stretch : held_stretches) {
    VibrationTimes there{std::move(stretch.windows), {}};
    there.is_stretch = held_stretches.size() > 1;
    there.swing = swing_windows(there.driven, result.first_period.value(),
                                job.part.damping, history.instants.back().time);
    stretches.push_back({stretch.hold_time, std::move(there)});
  }
  found = vibrate(moving, stretches);
  found.not_followed = unknown;
  found.seconds = watch.lap();
  return found;
}

/// What stresses of a motion make of a part's stiffness.
struct AxialStress {
  double factor;      ///< of buckling [1]
  double stiffening;  ///< of BucklingCheck [1]
};

/// Why a part's vibration is not known where its first frequency is not that of
/// its shapes at rest; empty: it is.
/// @param result  with a first period.
std::string not_known_moved(const PartJob& job, const LoadSet& given,
                            const PartResult& result,
                            const AxialStress& axial) {
  const double first = result.first_period.value();
  constexpr double kSlender = 10.0;
  constexpr double kGuided = 1.25;  // squares, by regression.sliding_rods
  const LoadSet motion = followed_loads(given);
  if (spins_fast(job, motion, first)) return {};  // not_known_spinning()
  const dynamics::LoadPath components = load_components(job, motion);
  const TurningPart turning = turning_part(job, motion, first);
  double low = 1.0 - turning.shift, high = 1.0 + turning.shift;
  double rise = rise_near(job, components, first, low, high);
  const auto counts = [&] {
    return rise > kRiseCounts && rise_decides(job.part, result, rise);
  };
  if (counts()) {
    return fmt::format(
        "it turns at {:.2g} of its first frequency, and where its inertia "
        "stiffens or softens it is not computed: it may swing {:.2g} times as "
        "far",
        turning.speed, rise);
  }
  if (axial.factor < kSlender) low -= 1.0 / axial.factor;
  rise = rise_near(job, components, first, low, high);
  if (counts()) {
    return fmt::format(
        "it buckles at {:.4g} times its loads, which lowers its first "
        "frequency to where it may swing {:.2g} times as far",
        axial.factor, rise);
  }
  if (axial.stiffening > 1.0 / kSlender) high += axial.stiffening;
  rise = rise_near(job, components, first, low, high);
  if (counts()) {
    return fmt::format(
        "its loads pull on it, which raises its first frequency by up to "
        "{:.2g}, to where it may swing {:.2g} times as far",
        std::sqrt(1.0 + axial.stiffening), rise);
  }
  const bool slides =
      std::ranges::any_of(motion.history.seats, [](const loads::Seat& seat) {
        return !!seat.slide;
      });
  if (slides) high *= kGuided;
  rise = rise_near(job, components, first, low, high);
  if (!counts()) return {};
  return fmt::format(
      "a guide holds it, and its first frequency may be 11 % higher than "
      "computed, where it may swing {:.2g} times as far",
      rise);
}

}  // namespace

void doubt_moved_frequencies(const PartJob& job,
                             const std::vector<double>& stiffening,
                             PartResult& result) {
  if (!result.first_period || !result.vibration.not_followed.empty()) return;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const auto& factors = result.buckling.of_motions;
    std::string unknown =
        not_known_moved(job, job.load_sets[s], result,
                        {s < factors.size() ? factors[s] : HUGE_VAL,
                         s < stiffening.size() ? stiffening[s] : 0.0});
    if (unknown.empty()) continue;
    result.vibration.not_followed = std::move(unknown);
    return;
  }
}

void doubt_spun_frequencies(const PartJob& job, HeldMotions& held,
                            PartResult& result) {
  if (!result.first_period || !result.vibration.not_followed.empty()) return;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const LoadSet motion = followed_loads(job.load_sets[s]);
    if (spins_fast(job, motion, *result.first_period)) continue;
    std::string unknown =
        not_known_by_spin(job, result, motion, held.moved_by_spin(s));
    if (unknown.empty()) continue;
    result.vibration.not_followed = std::move(unknown);
    return;
  }
}

void check_vibration(const PartJob& job, const std::vector<InstantRow>& rows,
                     HeldMotions& held, PartResult& result) {
  std::optional<VibrationResult> most;
  const double at_rest = result.deflection;
  double seconds = 0.0;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const LoadSet& given = job.load_sets[s];
    auto found = vibration_of(job, s, held, result);
    if (!found) continue;
    seconds += found->seconds;
    if (found->ratio) {
      judge_vibration(followed_loads(given), largest_of(rows, s, given, result),
                      result, *found);
      deflect(has_other_loads(job, result), *found, result);
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
}

}  // namespace clevis::assessment
