#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace clevis::numerics {

/// Which value a table has at a step: as just before or just behind it.
enum class StepSide { kBefore, kBehind };

/// Linear between the points, constant outside; a step where two times are
/// equal.
/// @param times  not decreasing, one or more; t in the units of these.
/// @param values  one for each. @return in the units of the values.
inline double linear_at(const std::vector<double>& times,
                        const std::vector<double>& values, double t,
                        StepSide side = StepSide::kBehind) {
  const auto next = side == StepSide::kBehind
                        ? std::ranges::upper_bound(times, t)
                        : std::ranges::lower_bound(times, t);
  if (next == times.begin()) return values.front();
  if (next == times.end()) return values.back();
  const auto k = static_cast<std::size_t>(next - times.begin());
  const double part = (t - times[k - 1]) / (times[k] - times[k - 1]);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

}  // namespace clevis::numerics
