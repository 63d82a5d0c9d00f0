#include "mechanism/sampling/law_times.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mechanism/sampling/driven_sampling.h"

namespace clevis::mechanism {
namespace {

/// Fills one after the other.
class Collector {
 public:
  Collector(LawTimes& times, double duration, double most)
      : times_(times), duration_(duration), most_(most) {}

  void drive(const DriveDefinition& drive) {
    switch (drive.law) {
      case DriveLaw::kConstant:
        return;
      case DriveLaw::kSpeed:
        step(drive.start);
        return;
      case DriveLaw::kSine:
        step(drive.start);
        sine(drive);
        return;
      case DriveLaw::kTable:
        spline(drive.table, drive.start);
        step(drive.start + drive.table.times.front());
        step(drive.start + drive.table.times.back());
        return;
      case DriveLaw::kQuintic:
        quintic(drive);
        [[fallthrough]];
      case DriveLaw::kRamp:
        step(drive.start);
        step(drive.start + drive.duration);
    }
  }

  void element(const ForceElement& element) {
    const ElementProperties given = properties(element);
    for (const double t : given.breakpoints) add(t, times_.breakpoints);
    for (const double t : given.steps) step(t);
    if (given.reference != nullptr) drive(*given.reference);
    for (const numerics::CubicSpline* path : given.paths) spline(*path, 0.0);
  }

 private:
  void add(double t, std::vector<double>& to) {
    if (t > 0.0 && t < duration_) to.push_back(t);
  }
  void step(double t) { add(t, times_.steps); }

  void sine(const DriveDefinition& drive) {
    if (!(drive.frequency > 0.0) || drive.amplitude == 0.0) return;
    const double quarter = 0.25 / drive.frequency;
    const double count = (duration_ - drive.start) / quarter;
    if (count > most_) {
      times_.all = false;
      return;
    }
    for (double k = 1.0; k < count; k += 1.0) {
      add(drive.start + k * quarter, times_.looks);
    }
    most_ -= std::max(count, 0.0);
  }

  /// Extremes of its acceleration, 60 s (1 − s) (1 − 2 s), and zeros.
  void quintic(const DriveDefinition& drive) {
    const double extreme = 0.5 - 0.5 / std::sqrt(3.0);
    for (const double s : {extreme, 0.5, 1.0 - extreme}) {
      add(drive.start + s * drive.duration, times_.looks);
    }
  }

  /// Its third derivative jumps at its knots.
  void spline(const numerics::CubicSpline& spline, double start) {
    constexpr int kPerPiece = 4;
    const std::vector<double>& knots = spline.times;
    for (const double t : knots) add(start + t, times_.knots);
    if (kPerPiece * static_cast<double>(knots.size()) > most_) return;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const double h = knots[i + 1] - knots[i];
      for (int k = 1; k < kPerPiece; ++k) {
        add(start + knots[i] + h * k / kPerPiece, times_.looks);
      }
    }
    most_ -= kPerPiece * static_cast<double>(knots.size());
  }

  LawTimes& times_;
  double duration_, most_;
};

void sort_once(std::vector<double>& times) {
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

}  // namespace

LawTimes law_times(const MechanismDefinition& definition, double duration,
                   double most) {
  LawTimes times;
  Collector collector(times, duration, most);
  for (const DriveDefinition& drive : definition.drives) {
    collector.drive(drive);
  }
  for (const ForceElement& element : definition.elements) {
    collector.element(element);
  }
  for (auto* each :
       {&times.steps, &times.breakpoints, &times.knots, &times.looks}) {
    sort_once(*each);
  }
  for (auto* each : {&times.breakpoints, &times.knots, &times.looks}) {
    std::erase_if(*each, [&times](double t) {
      return std::ranges::binary_search(times.steps, t);
    });
  }
  return times;
}

std::vector<double> bends_of_laws(const LawTimes& times) {
  std::vector<double> bends;
  std::ranges::set_union(times.breakpoints, times.knots,
                         std::back_inserter(bends));
  return bends;
}

std::vector<double> instants_of_laws(const LawTimes& times, double duration) {
  constexpr std::size_t kCrowd = 1000;  // bends: the largest loads then choose
  std::vector<double> instants;
  if (times.breakpoints.size() <= kCrowd) instants = times.breakpoints;
  const double side = 0.5 * kSides * duration;
  for (const double t : times.steps) {
    if (t <= 2.0 * side || t >= duration - 2.0 * side) continue;
    instants.push_back(t - side);
    instants.push_back(t + side);
  }
  std::ranges::sort(instants);
  return instants;
}

}  // namespace clevis::mechanism
