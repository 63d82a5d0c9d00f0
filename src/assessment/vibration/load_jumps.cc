#include "assessment/vibration/load_jumps.h"

#include <algorithm>

#include <Eigen/Core>

#include "loads/history/motion_instants.h"

namespace clevis::assessment {
namespace {

/// Forces, and moments over the size, that act on the surface [N].
Eigen::VectorXd surface_forces(const loads::InstantLoad& instant, double size) {
  std::vector<double> all;
  const auto put = [&](const loads::Wrench& wrench) {
    all.insert(all.end(), wrench.force.begin(), wrench.force.end());
    for (const double moment : wrench.moment) all.push_back(moment / size);
  };
  for (const loads::Wrench& wrench : instant.wrenches) put(wrench);
  for (const auto& load : instant.surface_loads) {
    put(load.resultant);
    all.push_back(load.total);
  }
  return Eigen::Map<const Eigen::VectorXd>(
      all.data(), static_cast<Eigen::Index>(all.size()));
}

}  // namespace

LoadSet motion_loads(const PartJob& job) {
  LoadSet set = job.load_sets.front();
  set.history.instants.resize(loads::motion_length(set.history));
  return set;
}

std::vector<LoadJump> load_jumps(const PartJob& job) {
  constexpr double kJump = 0.02, kNothing = 1e-3;
  if (job.load_sets.empty()) return {};
  const LoadSet& set = job.load_sets.front();
  const auto& instants = set.history.instants;
  const std::size_t length = loads::motion_length(set.history);
  if (length < 2 || !set.fixed.empty() || !set.foundations.empty()) return {};
  const double size = job.longest_side();
  const auto forces_at = [&](std::size_t i) -> Eigen::ArrayXd {
    return surface_forces(instants[i], size);
  };
  Eigen::ArrayXd largest = forces_at(0).abs();
  for (std::size_t i = 1; i < length; ++i) {
    largest = largest.max(forces_at(i).abs());
  }
  if (largest.size() == 0 || !(largest.maxCoeff() > 0.0)) return {};
  // A component that is nothing beside the others jumps by nothing.
  const Eigen::ArrayXd counting =
      (largest > kNothing * largest.maxCoeff()).cast<double>();
  const Eigen::ArrayXd scale =
      counting / largest.max(kNothing * largest.maxCoeff());
  const double sides = loads::kEventSides * loads::motion_duration(set.history);
  std::vector<LoadJump> jumps;
  for (std::size_t i = 1; i < length; ++i) {
    const double time = instants[i].time;
    if (time - instants[i - 1].time > sides) continue;
    const Eigen::ArrayXd after = forces_at(i);
    const Eigen::ArrayXd jump = (after - forces_at(i - 1)).abs();
    if ((jump * scale).maxCoeff() <= kJump) continue;
    if (!jumps.empty()) jumps.back().stays = time - jumps.back().time;
    jumps.push_back({time, instants[length - 1].time - time,
                     ((after.abs() + jump) * scale).maxCoeff()});
  }
  return jumps;
}

}  // namespace clevis::assessment
