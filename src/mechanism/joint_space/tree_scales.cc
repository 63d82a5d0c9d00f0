// How far states of a tree may err, and how they may change.
#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "mechanism/joint_space/tree_system.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

/// Of what hangs on a link, from its centre of mass [m].
double TreeSystem::reach(std::size_t link) const {
  const auto& links = coordinates_.links();
  double reach = 0.0;
  for (std::size_t k = link + 1; k < links.size(); ++k) {
    int at = links[k].parent;
    while (at > static_cast<int>(link)) at = links[index(at)].parent;
    if (at != static_cast<int>(link)) continue;
    reach =
        std::max(reach, (x_[links[k].slot].p - x_[links[link].slot].p).norm());
  }
  return reach;
}

/// Turns of a joint move what hangs on it: so far that it counts as a length.
void TreeSystem::set_scales() {
  const auto& links = coordinates_.links();
  const double length = equations_.layout().length();
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto& link = links[k];
    const double beyond = reach(k);
    for (int j = 0; j < link.count; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const Twist& S = coordinates_.motions()[k].S[at];
      const bool turns = S.w.squaredNorm() > 0.0;
      u_size_[index(link.u + link.order[at])] =
          turns ? length / std::max(length, beyond + S.v.norm()) : length;
    }
    const int first = quaternion_coordinate(link.kind);
    for (int j = 0; j < coordinate_count(link.kind); ++j) {
      const bool is_quaternion = first >= 0 && j >= first;
      q_size_[index(link.q + j)] =
          (is_quaternion ? 0.5 : 1.0) *
          u_size_[index(link.u + std::min(j, link.count - 1))];
    }
  }
}

void TreeSystem::scales(const VectorXd& z, VectorXd& scales) const {
  put_open(q_size_, u_size_, scales);
  scales.segment(velocity_index(), open_velocities()) *=
      scales_.speed_scale() / equations_.layout().length();
  loads_.forces().internal_scales(z.data() + internal_index(),
                                  scales.data() + internal_index());
  scales[work_index()] = 0.0;
}

void TreeSystem::error_weights(const VectorXd& z, VectorXd& weights) const {
  scales(z, weights);
  weights.head(work_index()) =
      (scales_.tolerance() * weights.head(work_index())).cwiseInverse();
}

Index TreeSystem::tangents(double t, const VectorXd& z, Eigen::MatrixXd& T) {
  place(t, z);
  T.setZero();
  const double rate = scales_.speed_scale() / equations_.layout().length();
  const Index n = open_velocities();
  for (Index i = 0; i < n; ++i) {
    const auto u = index(coordinates_.open_velocities()[index(i)]);
    std::ranges::fill(response_, 0.0);
    response_[u] = u_size_[u];
    coordinates_.rates(q_.data(), response_.data(), q_rate_.data());
    Index at = 0;
    for (const Index q : coordinates_.open_coordinates()) {
      T(at++, i) = q_rate_[index(q)];
    }
    T(velocity_index() + i, n + i) = rate * u_size_[u];
  }
  Index used = 2 * n;
  loads_.forces().internal_scales(z.data() + internal_index(),
                                  internal_.data());
  for (Index i = 0; i < internal_.size(); ++i) {
    if (internal_[i] == 0.0) continue;
    const Index at = internal_index() + i;
    T(at, used++) = std::max(internal_[i], std::abs(z[at]));
  }
  std::ranges::fill(response_, 0.0);  // driven ones stay so
  return used;
}

}  // namespace clevis::mechanism
