#include "scene/text/times.h"

#include <fmt/format.h>

namespace clevis::scene {

std::vector<double> increasing_times(const Value& times, std::size_t least,
                                     Steps steps) {
  std::vector<double> t;
  const auto is_step = [&] {
    const std::size_t n = t.size();
    return steps == Steps::kAllowed && t[n - 1] == t[n - 2] &&
           (n < 3 || t[n - 2] > t[n - 3]);
  };
  for (const Value& value : times.elements()) {
    t.push_back(value.quantity(Dimension::kTime));
    if (t.size() > 1 && !(t.back() > t[t.size() - 2]) && !is_step()) {
      throw value.refusal("S006", "is not after the time before it",
                          steps == Steps::kAllowed
                              ? "Give increasing times; two equal ones are a "
                                "step, three are none."
                              : "Give increasing times.");
    }
  }
  if (t.size() < least) {
    throw times.refusal("S006", "has fewer than two times",
                        "Give two or more, or a constant value.");
  }
  return t;
}

numerics::SplineEnds read_spline_ends(StrictTable& table) {
  const auto given = table.find("ends");
  if (!given) return numerics::SplineEnds::kClamped;
  return given->choice<numerics::SplineEnds>(
      {{"clamped", numerics::SplineEnds::kClamped},
       {"natural", numerics::SplineEnds::kNatural}});
}

}  // namespace clevis::scene
