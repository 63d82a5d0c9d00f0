#include "assessment/vibration/duration_ratio.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "assessment/pace/load_pace.h"
#include "assessment/pace/spinning_part.h"

namespace clevis::assessment {
namespace {

constexpr double kShort = 0.25;
constexpr const char* kInTime =
    "dynamic elements: the loads of the instants may be exceeded";

/// Whether one of the impact's touches lies in a window.
bool drives(const ImpactLoad& load,
            const std::vector<VibrationWindow>& windows) {
  return std::ranges::any_of(load.touches, [&](double touch) {
    return std::ranges::any_of(windows, [&](const VibrationWindow& window) {
      return window.from <= touch + load.duration && window.to >= touch;
    });
  });
}

void refer_to(double first, DurationRatio& rated) {
  rated.first_period = first;
  rated.ratio = rated.duration / first;
}

double amplification_of(const PartJob& job, const DurationRatio& pulse) {
  const double first = pulse.first_period;
  double most = 0.0;
  for (const double period : {first, std::min(period_of_waves(job), first)}) {
    most = std::max(most, pulse_amplification(pulse.duration / period,
                                              pulse.rise_time / period));
  }
  return most;
}

DurationRatio rated_impact(const PartJob& job, const ImpactLoad& load,
                           double first, bool in_time) {
  DurationRatio rated;
  rated.impact = load.name;
  rated.duration = load.duration;
  rated.rise_time = load.rise_time;
  refer_to(first, rated);
  rated.amplification = amplification_of(job, rated);
  rated.treatment = in_time ? kInTime
                    : rated.ratio < kShort
                        ? "beam impact: over before the part gives way, the "
                          "loads of the instants are an upper bound"
                        : "quasi-static: the loads of the instants suffice";
  return rated;
}

/// The change after which an oscillator answers most.
DurationRatio rated_change(const dynamics::ResponseSpectrum& spectrum,
                           const std::vector<VibrationWindow>& windows,
                           double first) {
  const auto window =
      std::ranges::find_if(windows, [&](const VibrationWindow& candidate) {
        return spectrum.time <= candidate.to;
      });
  const VibrationWindow& changes =
      window == windows.end() ? windows.back() : *window;
  DurationRatio rated;
  rated.impact =
      fmt::format("change of its loads near {:.6g} s", spectrum.time);
  rated.duration = changes.to - changes.from;
  refer_to(first, rated);
  rated.amplification = spectrum.amplification;
  rated.treatment = kInTime;
  return rated;
}

}  // namespace

std::optional<double> first_excited(const PartResult& result) {
  const double frequency = result.vibration.lowest_frequency;
  return frequency > 0.0 ? 1.0 / frequency : result.first_period;
}

double half_sine_amplification(double r) {
  constexpr double kPi = std::numbers::pi;
  if (!(r > 0.0)) return 0.0;
  // a mode of period 1 under sin(π t/r) up to r; then it swings freely
  const double a = 0.5 / r;  // ratio of frequencies
  if (std::abs(a - 1.0) < 1e-9) return 0.5 * kPi;
  const double scale = 1.0 / (1.0 - a * a);
  const auto at = [&](double t) {
    return scale * (std::sin(kPi * t / r) - a * std::sin(2.0 * kPi * t));
  };
  double largest = 0.0;
  constexpr int kTimes = 20000;
  for (int i = 0; i <= kTimes; ++i) {
    largest = std::max(largest, std::abs(at(r * i / kTimes)));
  }
  const double rate = scale * (kPi / r * std::cos(kPi) -
                               2.0 * kPi * a * std::cos(2.0 * kPi * r));
  return std::max(largest, std::hypot(at(r), rate / (2.0 * kPi)));
}

double pulse_amplification(double duration_over_period,
                           double rise_over_period) {
  constexpr double kLopsided = 0.4;  // of the duration; of a half sine 0.5
  const double half_sine = half_sine_amplification(duration_over_period);
  if (rise_over_period > kLopsided * duration_over_period ||
      duration_over_period < 0.5) {
    return half_sine;
  }
  const double step =
      1.0 + std::min(1.0, 1.0 / (std::numbers::pi * rise_over_period));
  return std::max(half_sine, step);
}

std::vector<VibrationWindow> judge_load_pace(const PartJob& job, std::size_t s,
                                             HeldMotions& held,
                                             PartResult& result) {
  const LoadSet& set = job.load_sets[s];
  const bool has_impacts = s == 0 && !job.impact_loads.empty();
  const LoadSet motion = followed_loads(set);
  const dynamics::LoadPath components = load_components(job, motion);
  bool slow = is_slow(job, set, components);
  if (slow && !has_impacts) return {};
  const double first = held.first_period(s);
  result.first_period = std::max(result.first_period.value_or(0.0), first);
  std::vector<VibrationWindow> windows;
  dynamics::ResponseSpectrum spectrum;
  if (!slow) {
    spectrum = load_spectrum(job, components, first);
    slow =
        spectrum.amplification <= kPaceCounts ||
        (spins_fast(job, motion, first) && stand_in_space(job, motion, first));
  }
  if (!slow) {
    const auto& time = components.time();
    windows = vibration_windows(spectrum.onsets, first,
                                {time[0], time[time.size() - 1]});
  }
  bool by_impact = false;
  for (const ImpactLoad& load :
       has_impacts ? job.impact_loads : std::vector<ImpactLoad>()) {
    const bool in_time = drives(load, windows);
    by_impact = by_impact || in_time;
    result.duration_ratios.push_back(rated_impact(job, load, first, in_time));
  }
  if (!windows.empty() && !by_impact) {
    result.duration_ratios.push_back(rated_change(spectrum, windows, first));
  }
  return windows;
}

void refer_to_vibration(const PartJob& job, PartResult& result) {
  const auto first = first_excited(result);
  if (!first) return;
  for (DurationRatio& rated : result.duration_ratios) {
    refer_to(*first, rated);
    if (rated.rise_time > 0.0) {  // a pulse; of changes the spectrum's stands
      rated.amplification = amplification_of(job, rated);
    }
  }
}

}  // namespace clevis::assessment
