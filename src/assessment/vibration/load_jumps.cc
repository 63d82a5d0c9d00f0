#include "assessment/vibration/load_jumps.h"

#include <algorithm>

#include <Eigen/Geometry>

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
  auto& instants = set.history.instants;
  std::size_t motion = 1;
  while (motion < instants.size() &&
         instants[motion].time > instants[motion - 1].time) {
    ++motion;
  }
  instants.resize(motion);
  return set;
}

std::vector<LoadJump> load_jumps(const PartJob& job) {
  constexpr double kJump = 0.02;
  if (job.load_sets.empty()) return {};
  const LoadSet set = motion_loads(job);
  const auto& instants = set.history.instants;
  if (instants.size() < 2 || !set.fixed.empty() || !set.foundations.empty()) {
    return {};
  }
  Eigen::AlignedBox3d box;
  for (const auto& vertex : job.mesh.vertices) box.extend(vertex);
  std::vector<Eigen::VectorXd> forces;
  double largest = 0.0;
  for (const auto& instant : instants) {
    forces.push_back(surface_forces(instant, box.sizes().maxCoeff()));
    if (forces.back().size() > 0) {
      largest = std::max(largest, forces.back().cwiseAbs().maxCoeff());
    }
  }
  const double sides =
      kEventSides * (instants.back().time - instants.front().time);
  std::vector<LoadJump> jumps;
  for (std::size_t i = 1; largest > 0.0 && i < instants.size(); ++i) {
    if (instants[i].time - instants[i - 1].time > sides) continue;
    const Eigen::VectorXd jump = forces[i] - forces[i - 1];
    if (jump.cwiseAbs().maxCoeff() <= kJump * largest) continue;
    const double time = instants[i].time;
    if (!jumps.empty()) jumps.back().stays = time - jumps.back().time;
    jumps.push_back(
        {time, instants.back().time - time,
         (forces[i].cwiseAbs() + jump.cwiseAbs()).maxCoeff() / largest});
  }
  return jumps;
}

}  // namespace clevis::assessment
