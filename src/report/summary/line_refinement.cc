#include "report/summary/line_refinement.h"

#include <cassert>
#include <cmath>
#include <iterator>
#include <queue>

namespace clevis::report {
namespace {

/// Between two kept samples the one that lies farthest off their line.
struct Farthest {
  double distance = 0.0;
  std::size_t at{}, from{}, to{};

  bool operator<(const Farthest& other) const {
    return distance < other.distance;
  }
};

Farthest farthest(std::span<const double> times, std::span<const double> values,
                  std::size_t from, std::size_t to) {
  Farthest found{0.0, from, from, to};
  const double span = times[to] - times[from];
  for (std::size_t i = from + 1; i < to; ++i) {
    const double part = span > 0.0 ? (times[i] - times[from]) / span : 0.0;
    const double line = (1.0 - part) * values[from] + part * values[to];
    const double distance = std::abs(values[i] - line);
    if (distance > found.distance) found = {distance, i, from, to};
  }
  return found;
}

}  // namespace

void refine_lines(std::set<std::size_t>& kept, std::span<const double> times,
                  std::span<const double> values, double tolerance,
                  std::size_t most) {
  assert(times.size() == values.size());
  std::priority_queue<Farthest> open;
  const auto look = [&](std::size_t from, std::size_t to) {
    const Farthest found = farthest(times, values, from, to);
    if (found.distance > tolerance) open.push(found);
  };
  for (auto at = kept.begin(); at != kept.end(); ++at) {
    if (const auto next = std::next(at); next != kept.end()) look(*at, *next);
  }
  while (!open.empty() && kept.size() < most) {
    const Farthest worst = open.top();
    open.pop();
    kept.insert(worst.at);
    look(worst.from, worst.at);
    look(worst.at, worst.to);
  }
}

}  // namespace clevis::report
