#include "assessment/vibration/stretch_vibration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "assessment/models/level.h"
#include "assessment/models/model_list.h"
#include "assessment/vibration/stretch_choice.h"
#include "base/messages/errors.h"
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

template <int dim>
int highest_degree(const mesh::PartMesh<dim>& mesh) {
  if (mesh.shape == mesh::CellShape::kSimplex) return 2;
  return dim == 2 ? 4 : 3;
}

/// What is touched of slides at the time of the hold; nothing: none is known.
std::optional<elasticity::TouchedSeats> touched_seats(
    const loads::LoadHistory& history) {
  if (!history.hold) return std::nullopt;
  auto zones = history.hold(history.hold_time).zones;
  if (zones.empty()) return std::nullopt;
  return elasticity::TouchedSeats{history.seats, std::move(zones)};
}

/// Largest of an answer over its times [m].
template <int dim>
double deflection_of(const RestingModel<dim>& rest, const Stretch& stretch,
                     VibratingAnswer<dim>& answer) {
  LoadSet set = rest.loads();
  set.history.hold_time = stretch.hold_time;
  if (set.fixed.empty() && set.foundations.empty()) {
    stress::remove_rigid_motion<dim>(answer.basis, reference_hold(set),
                                     touched_seats(set.history));
  }
  constexpr int kSixth = 6;  // of the times
  return stress::largest_deflection_of_many<dim>(answer.basis, kSixth);
}

/// @param largest  ratio of the stretches before: what is far below it by the
///   fewest shapes is not refined.
template <int dim>
LowVibration vibrate_low(const RestingModel<dim>& rest, const Stretch& stretch,
                         double largest) {
  constexpr double kRough = 1.0;
  LowVibration result{.count = kFewest, .still = rest.peak().value};
  int& count = result.count;
  VibratingModel<dim> low(rest, stretch.hold_time, stretch.times);
  const double settled = 0.3 * rest.job().tolerance;
  auto few = low.answer(count, rest.path(), Fronts::kTaken);
  double before = few.peak.value;
  if (is_far_below(before, largest * result.still)) {
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

}  // namespace

VibrationResult largest_vibration(const PartJob& job,
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

}  // namespace clevis::assessment
