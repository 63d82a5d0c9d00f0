#include "mechanism/drive_law.h"

#include <cmath>
#include <numbers>

namespace clevis::mechanism {
namespace {

DriveTarget sine(const DriveDefinition& drive, double t) {
  if (t < drive.start) return {.position = drive.from};
  const double omega = 2.0 * std::numbers::pi * drive.frequency;
  const double phase = omega * (t - drive.start);
  const double a = drive.amplitude;
  return {.position = drive.from + a * std::sin(phase),
          .rate = a * omega * std::cos(phase),
          .acceleration = -a * omega * omega * std::sin(phase)};
}

}  // namespace

DriveTarget drive_target(const DriveDefinition& drive, double t) {
  if (drive.law == DriveLaw::kConstant) return {.position = drive.from};
  if (drive.law == DriveLaw::kSine) return sine(drive, t);
  if (drive.law == DriveLaw::kTable) {
    const CubicSpline::Point point = drive.table.at(t - drive.start);
    return {point.value, point.rate, point.acceleration};
  }
  if (t < drive.start) return {.position = drive.from};
  if (t > drive.start + drive.duration || drive.duration <= 0.0) {
    return {.position = drive.to};
  }
  const double stroke = drive.to - drive.from;
  const double s = (t - drive.start) / drive.duration;
  const double s_rate = 1.0 / drive.duration;
  if (drive.law == DriveLaw::kRamp) {
    return {.position = drive.from + stroke * s, .rate = stroke * s_rate};
  }
  const double r = 1.0 - s;
  return {.position =
              drive.from + stroke * s * s * s * (10.0 + s * (6.0 * s - 15.0)),
          .rate = stroke * s_rate * 30.0 * s * s * r * r,
          .acceleration =
              stroke * s_rate * s_rate * 60.0 * s * r * (1.0 - 2.0 * s)};
}

}  // namespace clevis::mechanism
