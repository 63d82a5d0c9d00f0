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

/// Largest over the instants of each of several sharings.
std::vector<RoughPeak> largest_of(
    const PartJob& job, std::size_t set,
    const std::vector<std::vector<InstantLoad>>& sharings) {
  LoadSet loads = job.load_sets[set];
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

/// The least of one measure.
double least_by(double RoughPeak::*measure, const PartJob& job, std::size_t set,
                const std::vector<InstantLoad>& start,
                const std::vector<std::vector<InstantLoad>>& corners) {
  std::vector<InstantLoad> best = start;
  double least = largest_of(job, set, {best}).front().*measure;
  for (int round = 0; round < kRounds; ++round) {
    constexpr double kGain = 0.99;
    std::vector<std::vector<InstantLoad>> tried;
    for (const auto& corner : corners) {
      for (const double share : kShares) {
        tried.push_back(between(best, corner, share));
      }
    }
    const auto found = largest_of(job, set, tried);
    const auto lowest =
        std::ranges::min_element(found, {}, [&](const RoughPeak& one) {
          return one.*measure;
        });
    const double now = *lowest.*measure;
    if (now < least) {
      best = tried[static_cast<std::size_t>(lowest - found.begin())];
    }
    const bool goes_on = now < kGain * least;
    least = std::min(least, now);
    if (!goes_on) break;
  }
  return least;
}

}  // namespace

RoughPeak least_sharing(const PartJob& job, const OpenSharing& sharing) {
  const auto& checked = sharing.checked.instants;
  std::vector<InstantLoad> start;
  std::vector<std::vector<InstantLoad>> corners(
      std::min(kCorners, sharing.others.size()));
  for (const std::size_t i : hardest(checked)) {
    start.push_back(checked[i]);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k].push_back(sharing.others[k].instants[i]);
    }
  }
  return {least_by(&RoughPeak::stress, job, sharing.set, start, corners),
          least_by(&RoughPeak::deflection, job, sharing.set, start, corners)};
}

}  // namespace clevis::assessment
