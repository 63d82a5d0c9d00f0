#include "assessment/vibration/stretch_choice.h"

#include <algorithm>
#include <utility>

namespace clevis::assessment {

bool is_far_below(double ratio, double largest) {
  constexpr double kFar = 0.25;
  return ratio < kFar * largest;
}

bool is_covered(const LowVibration& low, const LowVibration& first,
                const VibrationResult& found) {
  if (!found.ratio || !(first.ratio > 0.0)) return false;
  constexpr double kElsewhere = 1.1;
  const bool is_near = !low.group.empty() && low.group == first.group;
  const double grown = std::max(1.0, *found.ratio / first.ratio);
  return low.most() * grown * (is_near ? 1.0 : kElsewhere) <=
         *found.ratio * (1.0 + found.error());
}

VibrationResult larger_of(VibrationResult a, VibrationResult b) {
  const auto most = [](const VibrationResult& one) {
    return one.ratio ? *one.ratio * (1.0 + one.error()) : 0.0;
  };
  const double deflection = std::max(a.deflection, b.deflection);
  VibrationResult& larger = most(a) > most(b) ? a : b;
  larger.deflection = deflection;
  return std::move(larger);
}

}  // namespace clevis::assessment
