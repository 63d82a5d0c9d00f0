#pragma once

namespace clevis::report {

// What people read; value in the unit = SI value / constant.
inline constexpr double kMillimetre = 1e-3;  ///< [m]
inline constexpr double kMegapascal = 1e6;   ///< [Pa]
inline constexpr double kMillijoule = 1e-3;  ///< [J]

}  // namespace clevis::report
