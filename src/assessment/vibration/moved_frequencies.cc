#include "assessment/vibration/moved_frequencies.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "assessment/pace/load_pace.h"
#include "assessment/pace/spinning_part.h"
#include "assessment/verdict/governing_peak.h"
#include "assessment/vibration/duration_ratio.h"

namespace clevis::assessment {
namespace {

/// What stresses of a motion make of a part's stiffness.
struct AxialStress {
  double factor;      ///< of buckling [1]
  double stiffening;  ///< of BucklingCheck [1]
};

/// Why a part's vibration is not known where its first frequency is not that of
/// its shapes at rest; empty: it is.
/// @param motion  of followed_loads(). @param first  period [s].
std::string not_known_moved(const PartJob& job, const LoadSet& motion,
                            const PartResult& result, const AxialStress& axial,
                            double first) {
  constexpr double kSlender = 10.0;
  constexpr double kGuided = 1.25;  // squares, by regression.sliding_rods
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

void doubt_moved_frequencies(const PartJob& job, HeldMotions& held,
                             const std::vector<double>& stiffening,
                             PartResult& result) {
  if (!result.first_period || !result.vibration.not_followed.empty()) return;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const auto& factors = result.buckling.of_motions;
    const AxialStress axial{s < factors.size() ? factors[s] : HUGE_VAL,
                            s < stiffening.size() ? stiffening[s] : 0.0};
    auto held_as = held.meanwhile(s);
    if (held_as.empty()) {
      const LoadSet motion = followed_loads(job.load_sets[s]);
      for (const double first :
           {*result.first_period, *first_excited(result)}) {
        held_as.push_back({motion, first});
      }
    }
    for (const auto& [motion, first] : held_as) {
      if (motion.history.instants.size() < 2) continue;  // nothing drives it
      std::string unknown = not_known_moved(job, motion, result, axial, first);
      if (unknown.empty()) continue;
      result.vibration.not_followed = std::move(unknown);
      return;
    }
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

}  // namespace clevis::assessment
