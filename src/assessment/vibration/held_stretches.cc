#include "assessment/vibration/held_stretches.h"

#include <algorithm>
#include <cmath>

#include "assessment/vibration/load_pace.h"
#include "base/messages/errors.h"
#include "elasticity/vibration/eigenmodes.h"
#include "loads/holds/slide_places.h"

namespace clevis::assessment {
namespace {

using loads::SlidePlaces;

/// The time by which half of the windows' is over [s].
double middle_of(const std::vector<VibrationWindow>& windows) {
  double whole = 0.0;
  for (const VibrationWindow& window : windows) {
    whole += window.to - window.from;
  }
  double left = 0.5 * whole;
  for (const VibrationWindow& window : windows) {
    const double length = window.to - window.from;
    if (left <= length) return window.from + left;
    left -= length;
  }
  return windows.back().to;
}

/// Those of a slide's places, in their order along its wall; none: none
/// travels.
std::vector<HeldStretch> by_place(const PartJob& job, const LoadSet& motion) {
  constexpr double kLittle = 0.01;
  constexpr int kPlaces = 4;
  const auto& instants = motion.history.instants;
  const SlidePlaces places =
      loads::slide_places(motion.history, kPlaces, kLittle * job.sides()[2]);
  if (places.bins < 2) return {};
  std::vector<HeldStretch> by_bin(static_cast<std::size_t>(places.bins));
  int bin = SlidePlaces::kUnknown;
  double from = instants.front().time;
  const auto close = [&](double to) {
    if (bin == SlidePlaces::kUnknown || !(to > from)) return;
    by_bin[static_cast<std::size_t>(bin)].windows.push_back({from, to});
  };
  for (std::size_t i = 0; i < places.of.size(); ++i) {
    const int next = places.of[i];
    if (next == bin || next == SlidePlaces::kUnknown) continue;
    if (bin != SlidePlaces::kUnknown) {
      const double between = 0.5 * (instants[i - 1].time + instants[i].time);
      close(between);
      from = between;
    }
    bin = next;
  }
  close(instants[places.of.size() - 1].time);
  std::erase_if(by_bin, [](const HeldStretch& stretch) {
    return stretch.windows.empty();
  });
  for (HeldStretch& stretch : by_bin) {
    stretch.hold_time = middle_of(stretch.windows);
  }
  return by_bin;
}

/// First period of a part that is held as at a time [s].
double period_held(const PartJob& job, const LoadSet& set, double time) {
  loads::LoadHistory history = set.history;
  history.hold_time = time;
  const bool is_simplex = job.mesh.shape == mesh::CellShape::kSimplex;
  for (const int degree : {2, is_simplex ? 1 : 2}) {  // memory may hold less
    try {
      return elasticity::first_period<3>({.mesh = job.overall_mesh(),
                                          .material = job.part.material,
                                          .history = history,
                                          .fixed = set.fixed,
                                          .name = job.part.name,
                                          .foundations = set.foundations},
                                         degree);
    } catch (const Error&) {
      continue;
    }
  }
  return longest_period(job, set);  // supports that hold it in a plane alone
}

bool are_like(double period, double other) {
  constexpr double kLike = 0.02;  // as the width of a resonance
  return std::abs(period - other) <= kLike * std::max(period, other);
}

std::vector<HeldStretch> found_stretches(const PartJob& job,
                                         const LoadSet& motion) {
  std::vector<HeldStretch> all = by_place(job, motion);
  const auto find = [&](HeldStretch& stretch) {
    stretch.period = period_held(job, motion, stretch.hold_time);
  };
  HeldStretch whole{motion.history.hold_time, {{-HUGE_VAL, HUGE_VAL}}};
  if (all.size() < 2) {
    find(whole);
    return {whole};
  }
  find(all.front());
  find(all.back());
  if (are_like(all.front().period, all.back().period)) {
    whole.period = std::max(all.front().period, all.back().period);
    return {whole};
  }
  for (std::size_t i = 1; i + 1 < all.size(); ++i) find(all[i]);
  return all;
}

}  // namespace

const std::vector<HeldStretch>& HeldMotions::stretches(std::size_t set) {
  auto& found = stretches_[set];
  if (!found) {
    found = found_stretches(job_, followed_loads(job_.load_sets[set]));
  }
  return *found;
}

double HeldMotions::first_period(std::size_t set) {
  return std::ranges::max_element(stretches(set), {}, &HeldStretch::period)
      ->period;
}

std::vector<VibrationWindow> in_both(const std::vector<VibrationWindow>& a,
                                     const std::vector<VibrationWindow>& b) {
  std::vector<VibrationWindow> both;
  for (const VibrationWindow& one : a) {
    for (const VibrationWindow& other : b) {
      const VibrationWindow shared{std::max(one.from, other.from),
                                   std::min(one.to, other.to)};
      if (shared.to > shared.from) both.push_back(shared);
    }
  }
  return both;
}

}  // namespace clevis::assessment
