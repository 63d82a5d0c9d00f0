#pragma once

#include <vector>

namespace clevis::numerics {

/// Ends of a cubic spline.
enum class SplineEnds {
  kClamped,  ///< at rest: slope zero
  kNatural   ///< second derivative zero
};

/// Twice continuously differentiable piecewise cubic through given values, in
/// the units of these; times [s].
struct CubicSpline {
  std::vector<double> times;   ///< increasing, two or more
  std::vector<double> values;  ///< one per time
  std::vector<double> second;  ///< second derivatives there

  /// Value and its first two derivatives.
  struct Point {
    double value{}, rate{}, acceleration{};
  };
  /// Constant before the first time and after the last.
  Point at(double t) const;
};

/// The interpolating spline, by the tridiagonal equations for its second
/// derivatives m: h_{i−1} m_{i−1} + 2 (h_{i−1} + h_i) m_i + h_i m_{i+1} =
/// 6 (s_i − s_{i−1}), s the slopes of the chords.
/// @param values  in any unit. @pre times [s] increase, at least two.
CubicSpline interpolating_spline(std::vector<double> times,
                                 std::vector<double> values, SplineEnds ends);

}  // namespace clevis::numerics
