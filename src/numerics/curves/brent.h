#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace clevis::numerics {

/// Root of f in [a, b] by Brent's method, to its
/// round-off; a and b in the units of f's argument.
/// @pre f_a > 0 >= f_b. @return a point at or just beyond the root.
template <typename Function>
double brent_root(Function f, double a, double f_a, double b, double f_b) {
  const double exact = 4.0 * std::numeric_limits<double>::epsilon() *
                       std::max({std::abs(a), std::abs(b), b - a});
  double c = a, f_c = f_a, step = b - a, last = step;
  for (int i = 0; i < 100; ++i) {
    if (std::abs(f_c) < std::abs(f_b)) {
      a = b, b = c, c = a;
      f_a = f_b, f_b = f_c, f_c = f_a;
    }
    const double middle = 0.5 * (c - b);
    if (std::abs(middle) <= exact || f_b == 0.0) break;
    if (std::abs(last) >= exact && std::abs(f_a) > std::abs(f_b)) {
      const double s = f_b / f_a;
      double p = 2.0 * middle * s, q = 1.0 - s;
      if (a != c) {
        const double r = f_b / f_c, u = f_a / f_c;
        p = s * (2.0 * middle * u * (u - r) - (b - a) * (r - 1.0));
        q = (u - 1.0) * (r - 1.0) * (s - 1.0);
      }
      if (p > 0.0) q = -q;
      p = std::abs(p);
      const bool inside =
          2.0 * p <
          std::min(3.0 * middle * q - std::abs(exact * q), std::abs(last * q));
      last = inside ? step : middle;
      step = inside ? p / q : middle;
    } else {
      last = step = middle;
    }
    a = b;
    f_a = f_b;
    b += std::abs(step) > exact ? step : std::copysign(exact, middle);
    f_b = f(b);
    if ((f_b > 0.0) == (f_c > 0.0)) {
      c = a, f_c = f_a;
      last = step = b - a;
    }
  }
  return f_b <= 0.0 ? b : c;
}

}  // namespace clevis::numerics
