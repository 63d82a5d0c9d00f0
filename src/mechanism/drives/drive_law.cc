#include "mechanism/drives/drive_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clevis::mechanism {
namespace {

/// Whether t is before a law's start; at the start itself as the side says.
bool before(double t, double start, BreakpointSide side) {
  return t < start || (t == start && side == BreakpointSide::kBefore);
}

bool behind(double t, double end, BreakpointSide side) {
  return t > end || (t == end && side == BreakpointSide::kBehind);
}

DriveTarget sine(const DriveDefinition& drive, double t, BreakpointSide side) {
  if (before(t, drive.start, side)) return {.position = drive.from};
  const double omega = 2.0 * std::numbers::pi * drive.frequency;
  const double phase = omega * (t - drive.start);
  const double a = drive.amplitude;
  return {.position = drive.from + a * std::sin(phase),
          .rate = a * omega * std::cos(phase),
          .acceleration = -a * omega * omega * std::sin(phase)};
}

/// Where a law starts and ends.
std::vector<double> bends(const DriveDefinition& drive) {
  switch (drive.law) {
    case DriveLaw::kConstant:
      return {};
    case DriveLaw::kSine:
    case DriveLaw::kSpeed:
      return {drive.start};
    case DriveLaw::kTable:
      return {drive.start + drive.table.times.front(),
              drive.start + drive.table.times.back()};
    default:
      return {drive.start, drive.start + drive.duration};
  }
}

/// Round-off of rates is a part of it. Sines and speeds know theirs exactly.
double mean_speed(const DriveDefinition& drive) {
  if (drive.law == DriveLaw::kSine || drive.law == DriveLaw::kSpeed) return 0.0;
  if (drive.law != DriveLaw::kTable) {
    return std::abs(drive.to - drive.from) / drive.duration;
  }
  const numerics::CubicSpline& table = drive.table;
  const auto [least, most] = std::ranges::minmax(table.values);
  return (most - least) / (table.times.back() - table.times.front());
}

}  // namespace

DriveTarget drive_target(const DriveDefinition& drive, double t,
                         BreakpointSide side) {
  if (drive.law == DriveLaw::kConstant) return {.position = drive.from};
  if (drive.law == DriveLaw::kSine) return sine(drive, t, side);
  if (drive.law == DriveLaw::kSpeed) {
    if (before(t, drive.start, side)) return {.position = drive.from};
    return {.position = drive.from + drive.speed * (t - drive.start),
            .rate = drive.speed};
  }
  if (drive.law == DriveLaw::kTable) {
    const numerics::CubicSpline& table = drive.table;
    if (before(t, drive.start + table.times.front(), side)) {
      return {.position = table.values.front()};
    }
    if (behind(t, drive.start + table.times.back(), side)) {
      return {.position = table.values.back()};
    }
    const numerics::CubicSpline::Point point = table.at(
        std::clamp(t - drive.start, table.times.front(), table.times.back()));
    return {point.value, point.rate, point.acceleration};
  }
  if (before(t, drive.start, side)) return {.position = drive.from};
  if (behind(t, drive.start + drive.duration, side) || drive.duration <= 0.0) {
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

std::vector<DriveJump> drive_jumps(const std::vector<DriveDefinition>& drives,
                                   double duration) {
  constexpr double kRoundOff = 1e-9;  // of a spline's slopes at its ends
  std::vector<DriveJump> jumps;
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const DriveDefinition& drive = drives[k];
    for (const double t : bends(drive)) {
      if (!(t > 0.0 && t < duration)) continue;
      const double first = drive_target(drive, t, BreakpointSide::kBefore).rate;
      const double then = drive_target(drive, t, BreakpointSide::kBehind).rate;
      if (std::abs(then - first) <= kRoundOff * mean_speed(drive)) continue;
      jumps.push_back({t, static_cast<int>(k), first, then});
    }
  }
  std::ranges::sort(jumps, {}, &DriveJump::t);
  return jumps;
}

}  // namespace clevis::mechanism
