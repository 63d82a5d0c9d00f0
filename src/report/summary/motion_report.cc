#include "report/summary/motion_report.h"

#include <algorithm>
#include <cmath>

namespace clevis::report {

using Eigen::Vector3d;

Vector3d marker_position(const mechanism::MarkerDefinition& marker,
                         const mechanism::Instant& instant) {
  if (marker.body == mechanism::kGround) return marker.p_LP;
  const mechanism::Pose& pose =
      instant.bodies[static_cast<std::size_t>(marker.body)].pose;
  return pose.p_WL + pose.R_WL * marker.p_LP;
}

std::vector<std::size_t> shown_instants(const mechanism::Motion& motion) {
  const std::size_t n = motion.instants.size();
  if (n == 0) return {};
  const double middle =
      0.5 * (motion.instants.front().t + motion.instants.back().t);
  std::size_t nearest = 0;
  const auto away = [&](std::size_t i) {
    return std::abs(motion.instants[i].t - middle);
  };
  for (std::size_t i = 1; i < n; ++i) {
    if (away(i) < (1.0 - 1e-9) * away(nearest)) nearest = i;
  }
  std::vector<std::size_t> shown{0, nearest, n - 1};
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  return shown;
}

}  // namespace clevis::report
