#include "assessment/vibration/duration_ratio.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "assessment/vibration/load_jumps.h"
#include "elasticity/vibration/eigenmodes.h"

namespace clevis::assessment {
namespace {

constexpr double kSlow = 0.10, kShort = 0.25;
constexpr double kNoJump = 0.02;
constexpr const char* kInTime =
    "dynamic elements: the loads of the instants may be exceeded";

/// Of a part's first vibration along its longest way: 2 l/√(E/ρ) [s]. What is
/// over before the part bends may still run along it and meet its like.
double period_of_waves(const PartJob& job) {
  return 2.0 * job.longest_side() *
         std::sqrt(job.part.material.density /
                   job.part.material.youngs_modulus);
}

/// The jump that reaches farthest, if that is beyond the loads of the instants.
std::optional<LoadJump> farthest_jump(const PartJob& job) {
  const auto jumps = load_jumps(job);
  const auto farthest = std::ranges::max_element(jumps, {}, &LoadJump::reach);
  if (farthest == jumps.end() || farthest->reach <= 1.0 + kNoJump) return {};
  return *farthest;
}

}  // namespace

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

bool wants_elements_in_time(const DurationRatio& rated) {
  const bool is_jump = rated.rise_time == 0.0;
  return rated.amplification > 1.0 + (is_jump ? kNoJump : kSlow);
}

void judge_duration_ratios(const PartJob& job, PartResult& result) {
  const std::optional<LoadJump> jump = farthest_jump(job);
  if (job.impact_loads.empty() && !jump) return;
  const loads::LoadHistory none;
  const double first = elasticity::first_period<3>(
      {job.overall_mesh(), job.part.material, none, {}, job.part.name},
      job.mesh.shape == mesh::CellShape::kSimplex ? 1 : 2);
  result.first_period = first;
  const double waves = std::min(period_of_waves(job), first);
  for (const ImpactLoad& load : job.impact_loads) {
    DurationRatio rated;
    rated.impact = load.name;
    rated.duration = load.duration;
    rated.rise_time = load.rise_time;
    rated.ratio = load.duration / first;
    for (const double period : {first, waves}) {
      rated.amplification = std::max(
          rated.amplification,
          pulse_amplification(load.duration / period, load.rise_time / period));
    }
    rated.treatment = wants_elements_in_time(rated) ? kInTime
                      : rated.ratio < kShort
                          ? "beam impact: over before the part gives way, the "
                            "loads of the instants are an upper bound"
                          : "quasi-static: the loads of the instants suffice";
    result.duration_ratios.push_back(rated);
  }
  if (jump) {
    DurationRatio rated;
    rated.impact = fmt::format("jump of its loads at {:.6g} s", jump->time);
    rated.duration = jump->stays;
    rated.ratio = jump->stays / first;
    rated.amplification = jump->reach;
    rated.treatment = kInTime;
    result.duration_ratios.push_back(rated);
  }
}

}  // namespace clevis::assessment
