#include "mechanism/sampling/driven_sampling.h"

#include <algorithm>
#include <utility>

namespace clevis::mechanism {

std::vector<double> uniform_times(const SimulationSettings& settings) {
  std::vector<double> times;
  for (int i = 0; i + 1 < settings.instants; ++i) {
    times.push_back(settings.duration * i / (settings.instants - 1));
  }
  times.push_back(settings.duration);
  return times;
}

void add_times(const std::vector<double>& more, double duration,
               std::vector<double>& times) {
  const double apart = kApart * duration;
  std::vector<double> sorted = more, all;
  std::ranges::sort(sorted);
  all.reserve(times.size() + sorted.size());
  auto next = times.begin();
  for (const double t : sorted) {
    while (next != times.end() && *next <= t) all.push_back(*next++);
    const bool is_known = (next != times.end() && *next - t < apart) ||
                          (!all.empty() && t - all.back() < apart);
    if (!is_known) all.push_back(t);
  }
  all.insert(all.end(), next, times.end());
  times = std::move(all);
}

}  // namespace clevis::mechanism
