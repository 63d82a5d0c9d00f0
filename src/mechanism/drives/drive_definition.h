#pragma once

#include <string>

#include "numerics/curves/cubic_spline.h"

namespace clevis::mechanism {

enum class DriveLaw { kConstant, kRamp, kQuintic, kSine, kTable, kSpeed };

/// Prescribed joint coordinate. Before `start` it rests at `from`, after
/// start + duration at `to`.
/// Sine: from + amplitude sin(2π frequency (t − start)).
/// Speed: from + speed (t − start), without end.
struct DriveDefinition {
  int joint{};  ///< index into MechanismDefinition::joints
  DriveLaw law{};
  double from{}, to{};              ///< [m] or [rad]
  double start{}, duration{};       ///< [s]
  double amplitude{}, frequency{};  ///< [m] or [rad], [Hz]
  std::string place;
  int coordinate{};  ///< which of the joint's
  numerics::CubicSpline
      table{};     ///< of a table: times after `start`, [m] or [rad]
  double speed{};  ///< [m/s] or [rad/s]
};

/// A drive that changes its speed in no time: rigid bodies answer with an
/// impulse, which no finite force tells.
struct DriveJump {
  double t{};  ///< [s]
  int drive{};
  double before{}, behind{};  ///< [m/s] or [rad/s]
};

}  // namespace clevis::mechanism
