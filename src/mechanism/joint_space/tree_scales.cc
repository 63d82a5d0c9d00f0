#include "mechanism/joint_space/tree_scales.h"

#include <algorithm>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

/// Of what hangs on a link, from its centre of mass [m].
double reach(const std::vector<JointLink>& links, const Configuration& x,
             std::size_t link) {
  double reach = 0.0;
  for (std::size_t k = link + 1; k < links.size(); ++k) {
    int at = links[k].parent;
    while (at > static_cast<int>(link)) at = links[index(at)].parent;
    if (at != static_cast<int>(link)) continue;
    reach =
        std::max(reach, (x[links[k].slot].p - x[links[link].slot].p).norm());
  }
  return reach;
}

}  // namespace

TreeScales tree_scales(const JointCoordinates& coordinates,
                       const Configuration& x, double length) {
  TreeScales scales{std::vector<double>(index(coordinates.coordinates())),
                    std::vector<double>(index(coordinates.velocities()))};
  const std::vector<JointLink>& links = coordinates.links();
  for (std::size_t k = 0; k < links.size(); ++k) {
    const JointLink& link = links[k];
    const double beyond = reach(links, x, k);
    for (int j = 0; j < link.count; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const Twist& S = coordinates.motions()[k].S[at];
      const bool turns = S.w.squaredNorm() > 0.0;
      scales.u[index(link.u + link.order[at])] =
          turns ? length / std::max(length, beyond + S.v.norm()) : length;
    }
    const int first = quaternion_coordinate(link.kind);
    for (int j = 0; j < coordinate_count(link.kind); ++j) {
      const bool is_quaternion = first >= 0 && j >= first;
      scales.q[index(link.q + j)] =
          (is_quaternion ? 0.5 : 1.0) *
          scales.u[index(link.u + std::min(j, link.count - 1))];
    }
  }
  return scales;
}

}  // namespace clevis::mechanism
