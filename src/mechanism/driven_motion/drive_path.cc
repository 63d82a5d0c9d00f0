#include "mechanism/driven_motion/drive_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {
namespace {

constexpr double kFarthest = 0.2;    // [rad], or of the length
constexpr double kMost = 300'000.0;  // steps, but as many as instants
constexpr double kTiny = 1e-12;      // of a time: no shorter steps

}  // namespace

DrivePath::DrivePath(const MechanismDefinition& definition,
                     const SolvingFrame& frame, bool counts_turns)
    : definition_(definition),
      length_(frame.length),
      // without loops nothing can be passed
      is_followed_(!frame.is_tree || counts_turns) {}

void DrivePath::refuse(double duration) const {
  throw Error("K008", "mechanism",
              fmt::format("until t = {:.6g} s the drives move so far that the "
                          "loops would take over {:.0f} steps to follow",
                          duration, kMost),
              "Ask for a shorter motion, a slower drive or more instants.");
}

/// Where a drive may turn round or bend.
std::vector<double> DrivePath::turns(double from, double to) const {
  constexpr int kPerKnot = 4;
  std::vector<double> times;
  const auto add = [&](double t) {
    if (t > from && t < to) times.push_back(t);
  };
  for (const DriveDefinition& drive : definition_.drives) {
    add(drive.start);
    add(drive.start + drive.duration);
    if (drive.law == DriveLaw::kSine && drive.frequency > 0.0) {
      const double quarter = 0.25 / drive.frequency;
      if ((to - from) / quarter > kMost) refuse(to);
      const double first = std::max(from, drive.start);
      double k = std::ceil((first - drive.start) / quarter);
      for (; drive.start + k * quarter < to; k += 1.0) {
        add(drive.start + k * quarter);
      }
    }
    const std::vector<double>& knots = drive.table.times;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      for (int k = 0; k < kPerKnot; ++k) {
        add(drive.start + knots[i] + (knots[i + 1] - knots[i]) * k / kPerKnot);
      }
    }
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  times.push_back(to);
  return times;
}

/// The largest of the drives, turns in radians, slides over the length.
double DrivePath::travel(double from, double to) const {
  double largest = 0.0;
  for (const DriveDefinition& drive : definition_.drives) {
    const double way = std::abs(drive_target(drive, to).position -
                                drive_target(drive, from).position);
    largest = std::max(largest,
                       drives_angle(definition_, drive) ? way : way / length_);
  }
  return largest;
}

void DrivePath::cut(double from, double to, std::vector<double>& times) const {
  if (travel(from, to) > kFarthest) {
    const double middle = 0.5 * (from + to);
    if (to - from > kTiny * to && middle > from && middle < to) {
      cut(from, middle, times);
      cut(middle, to, times);
      return;
    }
  }
  times.push_back(to);
}

std::vector<double> DrivePath::steps(double from, double to) const {
  if (!is_followed_) return {to};
  std::vector<double> times;
  double last = from;
  for (const double t : turns(from, to)) {
    cut(last, t, times);
    last = t;
  }
  return times;
}

void DrivePath::require_few_steps(double duration, int instants) const {
  if (!is_followed_) return;
  double way = 0.0, last = 0.0;
  for (const double t : turns(0.0, duration)) {
    way += travel(last, t);
    last = t;
  }
  if (way > kFarthest * std::max(kMost, 1.0 * instants)) refuse(duration);
}

}  // namespace clevis::mechanism
