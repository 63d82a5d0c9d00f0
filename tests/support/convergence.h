#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace clevis::support {

/// Order of convergence between two meshes whose sizes differ by `ratio`:
/// log(coarse / fine) / log(ratio).
inline double observed_rate(double coarse_error, double fine_error,
                            double ratio = 2.0) {
  return std::log(coarse_error / fine_error) / std::log(ratio);
}

/// Order between the last two of errors on meshes halved each time.
inline double last_rate(const std::vector<double>& errors) {
  const std::size_t n = errors.size();
  return observed_rate(errors[n - 2], errors[n - 1]);
}

}  // namespace clevis::support
