#pragma once

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

}  // namespace clevis::report
