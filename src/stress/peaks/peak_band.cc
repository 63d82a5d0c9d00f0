#include "stress/peaks/peak_band.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clevis::stress {

Band peak_band(std::span<const SequenceValue> sequence, double tolerance,
               double share_of_change_before) {
  assert(!sequence.empty());
  constexpr double kFastest = 0.35;
  constexpr double kSlowest = 0.8;
  constexpr double kSingularRatio = 0.75;
  const auto n = sequence.size();
  const double value = sequence[n - 1].value;
  if (value == 0.0) return {0.0, 0.0, 0.0, Convergence::kConverged};
  if (n < 3) return {value, 0.0, 2.0 * value, Convergence::kNotConverged};
  const double before = sequence[n - 2].value - sequence[n - 3].value;
  const double last = value - sequence[n - 2].value;
  const double ratio = before != 0.0 ? std::abs(last / before) : kSlowest;
  const double q = std::clamp(ratio, kFastest, kSlowest);
  const double half_width =
      std::max(std::abs(last) * std::max(0.5, q / (1.0 - q)),
               share_of_change_before * std::abs(before));
  Band band{value, value - half_width, value + half_width,
            Convergence::kConverged};
  if (half_width <= tolerance * std::abs(value)) return band;
  const bool grows = last * before > 0.0 && last * value > 0.0;
  band.verdict = grows && ratio > kSingularRatio ? Convergence::kSingular
                                                 : Convergence::kNotConverged;
  return band;
}

Band local_band(const LocalValues& values, double tolerance) {
  constexpr double kSafety = 0.65;
  constexpr double kPollution = 0.01;
  constexpr double kLeast = 0.01;
  const double half_width =
      std::max({kSafety * std::abs(values.finest - values.value),
                std::abs(values.finest - values.finer),
                kPollution * std::abs(values.value - values.before),
                kPollution * std::abs(values.elsewhere),
                kLeast * tolerance * std::abs(values.finest)});
  Band band{values.value, std::min(values.finest - half_width, values.value),
            std::max(values.finest + half_width, values.value),
            Convergence::kConverged};
  const double reach = std::max(band.high - band.value, band.value - band.low);
  if (!(reach <= tolerance * std::abs(values.value))) {
    band.verdict = Convergence::kNotConverged;
  }
  return band;
}

}  // namespace clevis::stress
