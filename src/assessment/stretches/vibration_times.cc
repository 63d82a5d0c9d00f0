#include "assessment/stretches/vibration_times.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace clevis::assessment {
namespace {

void end_at(double end, std::vector<VibrationWindow>& windows) {
  std::erase_if(windows, [end](const VibrationWindow& window) {
    return window.from >= end;
  });
  for (VibrationWindow& window : windows) window.to = std::min(window.to, end);
}

}  // namespace

std::vector<VibrationWindow> joined(std::vector<VibrationWindow> all) {
  std::ranges::sort(all, {}, &VibrationWindow::from);
  std::vector<VibrationWindow> apart;
  for (const VibrationWindow& window : all) {
    if (!apart.empty() && window.from <= apart.back().to) {
      apart.back().to = std::max(apart.back().to, window.to);
    } else {
      apart.push_back(window);
    }
  }
  return apart;
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

double total_duration(const std::vector<VibrationWindow>& windows) {
  double sum = 0.0;
  for (const VibrationWindow& window : windows) sum += window.to - window.from;
  return sum;
}

VibrationWindow nearest_times(const std::vector<loads::InstantLoad>& instants,
                              std::size_t i) {
  const auto between = [&](std::size_t later) {
    return 0.5 * (instants[later - 1].time + instants[later].time);
  };
  return {i == 0 ? -HUGE_VAL : between(i),
          i + 1 == instants.size() ? HUGE_VAL : between(i + 1)};
}

std::vector<VibrationWindow> vibration_windows(
    const std::vector<double>& onsets, double period,
    const VibrationWindow& motion) {
  constexpr double kBefore = 1.0, kAfter = 5.0;  // first periods
  std::vector<VibrationWindow> all;
  for (const double onset : onsets) {
    all.push_back({std::max(motion.from, onset - kBefore * period),
                   onset + kAfter * period});
  }
  end_at(motion.to, all);
  return joined(std::move(all));
}

std::vector<VibrationWindow> swing_windows(
    const std::vector<VibrationWindow>& windows, double period, double damping,
    double end) {
  constexpr double kLeft = 0.05, kMost = 100.0;  // periods
  const double turn = 2.0 * std::numbers::pi;
  const double periods = std::min(kMost, -std::log(kLeft) / (turn * damping));
  auto all = windows;
  for (VibrationWindow& window : all) window.to += periods * period;
  end_at(end, all);
  return joined(std::move(all));
}

bool lies_in(const std::vector<VibrationWindow>& windows, double time) {
  return std::ranges::any_of(windows, [time](const VibrationWindow& window) {
    return time >= window.from && time <= window.to;
  });
}

std::vector<Eigen::Index> instants_within(
    const std::vector<VibrationWindow>& windows,
    const std::vector<loads::InstantLoad>& instants) {
  std::vector<Eigen::Index> within;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    if (lies_in(windows, instants[i].time)) {
      within.push_back(static_cast<Eigen::Index>(i));
    }
  }
  return within;
}

Eigen::VectorXd times_within(const std::vector<VibrationWindow>& windows,
                             double step, int most) {
  const double total = total_duration(windows);
  const double apart = std::max(step, total / most);
  std::vector<double> times;
  for (const VibrationWindow& window : windows) {
    const auto count = static_cast<int>((window.to - window.from) / apart);
    for (int i = 0; i <= count; ++i) times.push_back(window.from + i * apart);
  }
  return Eigen::Map<const Eigen::VectorXd>(
      times.data(), static_cast<Eigen::Index>(times.size()));
}

Eigen::VectorXd times_near_peaks(const Eigen::VectorXd& time,
                                 const Eigen::VectorXd& peak,
                                 const std::vector<VibrationWindow>& windows,
                                 std::size_t most) {
  constexpr int kBetween = 8;
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = 1; i + 1 < time.size(); ++i) {
    const bool tops = peak[i] >= peak[i - 1] && peak[i] >= peak[i + 1];
    if (tops && lies_in(windows, time[i])) order.push_back(i);
  }
  std::ranges::sort(order, std::ranges::greater{}, [&](Eigen::Index i) {
    return peak[i];
  });
  if (order.size() > most) order.resize(most);
  std::vector<double> times;
  for (const Eigen::Index i : order) {
    for (const Eigen::Index j : {i - 1, i}) {
      for (int k = 1; k < kBetween; ++k) {
        times.push_back(time[j] + k * (time[j + 1] - time[j]) / kBetween);
      }
    }
  }
  std::ranges::sort(times);
  return Eigen::Map<const Eigen::VectorXd>(
      times.data(), static_cast<Eigen::Index>(times.size()));
}

Eigen::VectorXd merged(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  Eigen::VectorXd both(a.size() + b.size());
  std::ranges::merge(a, b, both.begin());
  both.conservativeResize(std::unique(both.begin(), both.end()) - both.begin());
  return both;
}

}  // namespace clevis::assessment
