#include "mechanism/sampling/instant_brackets.h"

#include <algorithm>
#include <iterator>

namespace clevis::mechanism {

void bracket_by_instants(const std::vector<Instant>& instants,
                         std::vector<ChangePoint>& points) {
  for (ChangePoint& point : points) {
    const auto after =
        std::ranges::upper_bound(instants, point.t, {}, &Instant::t);
    if (after != instants.begin()) point.t_before = std::prev(after)->t;
    if (after != instants.end()) point.t_after = after->t;
  }
}

}  // namespace clevis::mechanism
