#pragma once

#include "mechanism/drive_definition.h"

namespace clevis::mechanism {

/// Prescribed coordinate of a drive and its time derivatives.
struct DriveTarget {
  double position{};      ///< [m] or [rad]
  double rate{};          ///< [m/s] or [rad/s]
  double acceleration{};  ///< [m/s²] or [rad/s²]
};

/// What the drive prescribes at time t [s].
///
/// Constant: `from`. Ramp: linear, quintic: 10 s³ − 15 s⁴ + 6 s⁵, from `from`
/// to `to` over [start, start + duration], at rest outside of it. Sine: at
/// rest before `start`, without end after it. Table: the spline, from `start`.
DriveTarget drive_target(const DriveDefinition& drive, double t);

}  // namespace clevis::mechanism
