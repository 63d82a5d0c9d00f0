#include "assessment/sharing/least_sharing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

namespace clevis::assessment {
namespace {

using loads::InstantLoad;
using loads::Wrench;

constexpr std::size_t kInstants = 3, kCorners = 16;
constexpr std::array kShares{0.15, 0.35, 0.6, 0.85};
constexpr int kRounds = 3;

Wrench between(const Wrench& a, const Wrench& b, double share) {
  return {a.force + share * (b.force - a.force),
          a.moment + share * (b.moment - a.moment)};
}

/// Loads between two of one instant, whose reactions alone differ.
InstantLoad between(const InstantLoad& a, const InstantLoad& b, double share) {
  InstantLoad load = a;
  for (std::size_t s = 0; s < load.wrenches.size(); ++s) {
    load.wrenches[s] = between(a.wrenches[s], b.wrenches[s], share);
  }
  for (std::size_t k = 0; k < load.surface_loads.size(); ++k) {
    auto& surface = load.surface_loads[k];
    const auto& other = b.surface_loads[k];
    surface.pressure += share * (other.pressure - surface.pressure);
    surface.traction += share * (other.traction - surface.traction);
    surface.resultant = between(surface.resultant, other.resultant, share);
    surface.total += share * (other.total - surface.total);
  }
  return load;
}

std::vector<InstantLoad> between(const std::vector<InstantLoad>& a,
                                 const std::vector<InstantLoad>& b,
                                 double share) {
  std::vector<InstantLoad> loads;
  for (std::size_t i = 0; i < a.size(); ++i) {
    loads.push_back(between(a[i], b[i], share));
  }
  return loads;
}

using Sharing = std::vector<InstantLoad>;

/// Largest over the instants of each of several sharings.
std::vector<RoughPeak> peaks_of(const PartJob& job, const OpenSharing& open,
                                const std::vector<Sharing>& sharings) {
  LoadSet loads = job.load_sets[open.set];
  loads.history = open.checked;  // the set's seats may be more
  loads.history.instants.clear();
  loads.history.repeats.clear();
  for (const auto& sharing : sharings) {
    std::ranges::copy(sharing, std::back_inserter(loads.history.instants));
  }
  const RoughAnswers answers = rough_answers(job, loads);
  std::vector<RoughPeak> largest;
  Eigen::Index first = 0;
  for (const auto& sharing : sharings) {
    const auto count = static_cast<Eigen::Index>(sharing.size());
    largest.push_back(largest_of(answers, first, count));
    first += count;
  }
  return largest;
}

double size_of(const InstantLoad& load) {
  double sum = 0.0;
  for (const Wrench& wrench : load.wrenches) sum += wrench.force.norm();
  return sum;
}

/// Indices of the instants with the largest forces.
std::vector<std::size_t> hardest(const std::vector<InstantLoad>& instants) {
  std::vector<std::size_t> order(instants.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t most = std::min(kInstants, order.size());
  std::ranges::partial_sort(order,
                            order.begin() + static_cast<std::ptrdiff_t>(most),
                            std::ranges::greater{}, [&](std::size_t i) {
                              return size_of(instants[i]);
                            });
  order.resize(most);
  return order;
}

/// From one sharing some of the way to each corner.
struct Round {
  std::vector<Sharing> tried;
  std::vector<RoughPeak> peaks;
};
Round round_from(const PartJob& job, const OpenSharing& open,
                 const Sharing& from, const std::vector<Sharing>& corners) {
  Round round;
  for (const Sharing& corner : corners) {
    for (const double share : kShares) {
      round.tried.push_back(between(from, corner, share));
    }
  }
  round.peaks = peaks_of(job, open, round.tried);
  return round;
}

/// The least of one measure.
/// @param start  of the sharing that was checked. @param round  the first.
double least_by(double RoughPeak::*measure, const PartJob& job,
                const OpenSharing& open, double start, Round round,
                const std::vector<Sharing>& corners) {
  constexpr double kGain = 0.99;
  double least = start;
  for (int k = 1;; ++k) {
    const auto lowest =
        std::ranges::min_element(round.peaks, {}, [&](const RoughPeak& one) {
          return one.*measure;
        });
    const double now = *lowest.*measure;
    const bool goes_on = k < kRounds && now < kGain * least;
    least = std::min(least, now);
    if (!goes_on) return least;
    const auto best = lowest - round.peaks.begin();
    round = round_from(job, open, round.tried[static_cast<std::size_t>(best)],
                       corners);
  }
}

}  // namespace

RoughPeak least_sharing(const PartJob& job, const OpenSharing& open) {
  Sharing start;
  std::vector<Sharing> corners(std::min(kCorners, open.others.size()));
  for (const std::size_t i : hardest(open.checked.instants)) {
    start.push_back(open.checked.instants[i]);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k].push_back(open.others[k].instants[i]);
    }
  }
  const RoughPeak checked = peaks_of(job, open, {start}).front();
  const Round first = round_from(job, open, start, corners);
  const auto least = [&](double RoughPeak::*measure) {
    return least_by(measure, job, open, checked.*measure, first, corners);
  };
  return {least(&RoughPeak::stress), least(&RoughPeak::deflection)};
}

}  // namespace clevis::assessment
