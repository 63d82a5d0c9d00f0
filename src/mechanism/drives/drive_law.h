#pragma once

#include <vector>

#include "mechanism/drives/drive_definition.h"

namespace clevis::mechanism {

/// Prescribed coordinate of a drive and its time derivatives.
struct DriveTarget {
  double position{};      ///< [m] or [rad]
  double rate{};          ///< [m/s] or [rad/s]
  double acceleration{};  ///< [m/s²] or [rad/s²]
};

/// Side from which a law is read at a time where it bends: as in its stroke, or
/// as just before or behind that time.
enum class BreakpointSide { kStroke, kBefore, kBehind };

/// Coordinate and rates that the drive prescribes at time t [s].
///
/// Constant: `from`. Ramp: linear, quintic: 10 s³ − 15 s⁴ + 6 s⁵, from `from`
/// to `to` over [start, start + duration], at rest outside of it. Sine: at
/// rest before `start`, without end after it, as Speed. Table: the spline, from
/// `start`.
DriveTarget drive_target(const DriveDefinition& drive, double t,
                         BreakpointSide side = BreakpointSide::kStroke);

/// Where drives change their speed in no time within a motion.
/// @param duration  of the motion [s].
std::vector<DriveJump> drive_jumps(const std::vector<DriveDefinition>& drives,
                                   double duration);

}  // namespace clevis::mechanism
