#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Core>
#include <fmt/format.h>

namespace clevis::report {

// Units that people read. Powers of ten >= 1 are exact, so 0.14 m becomes 140
// mm.

/// From [m], number or vector.
template <typename Length>
Length millimetres(const Length& metres) {
  return metres * 1e3;
}

/// From [Pa].
inline double megapascals(double pascals) {
  return pascals / 1e6;
}

/// From [J].
inline double millijoules(double joules) {
  return joules * 1e3;
}

/// "(12.5, -3.0, 4.0)": a place [m] in millimetres, to a tenth, and nearer to
/// the origin to three digits of its largest coordinate; zero without its sign.
inline std::string place_text(const Eigen::Vector3d& metres) {
  constexpr int kMostDecimals = 6;
  const Eigen::Vector3d at = millimetres(metres);
  const double largest = at.cwiseAbs().maxCoeff();
  int decimals = 1;
  if (largest > 0.0 && largest < 1.0) {
    decimals =
        std::min(kMostDecimals, 2 - int(std::floor(std::log10(largest))));
  }
  const double step = std::pow(10.0, -decimals);
  const auto rounded = [step](double x) {
    return std::round(x / step) * step + 0.0;  // of -0 as well
  };
  return fmt::format("({1:.{0}f}, {2:.{0}f}, {3:.{0}f})", decimals,
                     rounded(at.x()), rounded(at.y()), rounded(at.z()));
}

}  // namespace clevis::report
