#include "numerics/curves/cubic_spline.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace clevis::numerics {

CubicSpline::Point CubicSpline::at(double t) const {
  if (t < times.front()) return {.value = values.front()};
  if (t > times.back()) return {.value = values.back()};
  const auto above = std::ranges::upper_bound(times, t);
  const auto last = static_cast<std::ptrdiff_t>(times.size()) - 1;
  const auto j = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - times.begin(), 1, last));
  const std::size_t i = j - 1;
  const double h = times[j] - times[i];
  const double a = (times[j] - t) / h, b = (t - times[i]) / h;
  const double slope = (values[j] - values[i]) / h;
  return {.value = a * values[i] + b * values[j] +
                   ((a * a * a - a) * second[i] + (b * b * b - b) * second[j]) *
                       h * h / 6.0,
          .rate = slope + ((3.0 * b * b - 1.0) * second[j] -
                           (3.0 * a * a - 1.0) * second[i]) *
                              h / 6.0,
          .acceleration = a * second[i] + b * second[j]};
}

CubicSpline interpolating_spline(std::vector<double> times,
                                 std::vector<double> values, SplineEnds ends) {
  const std::size_t n = times.size();
  assert(n >= 2 && values.size() == n);
  // rows: lower, diagonal, upper, right-hand side
  std::vector<double> diagonal(n, 1.0), upper(n, 0.0), m(n, 0.0);
  std::vector<double> lower(n, 0.0);
  const auto h = [&times](std::size_t i) {
    return times[i + 1] - times[i];
  };
  const auto slope = [&](std::size_t i) {
    return (values[i + 1] - values[i]) / h(i);
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    lower[i] = h(i - 1);
    diagonal[i] = 2.0 * (h(i - 1) + h(i));
    upper[i] = h(i);
    m[i] = 6.0 * (slope(i) - slope(i - 1));
  }
  if (ends == SplineEnds::kClamped) {
    diagonal[0] = 2.0 * h(0);
    upper[0] = h(0);
    m[0] = 6.0 * slope(0);
    diagonal[n - 1] = 2.0 * h(n - 2);
    lower[n - 1] = h(n - 2);
    m[n - 1] = -6.0 * slope(n - 2);
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    m[i] -= factor * m[i - 1];
  }
  m[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) {
    m[i] = (m[i] - upper[i] * m[i + 1]) / diagonal[i];
  }
  return {std::move(times), std::move(values), std::move(m)};
}

}  // namespace clevis::numerics
