#include "mechanism/dynamic_state/state_scales.h"

#include <algorithm>
#include <cmath>

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Round-off of accelerations is that over the smallest pivot: motions that
// come near change points are not the better for steps beyond that.
constexpr double kRoundOff = 1e-16, kNearRank = 1e-11;

}  // namespace

void StateScales::note(const VectorXd& y, const VectorXd& accelerations,
                       double smallest_pivot, ForceModel& forces) {
  const double length = layout_.length();
  const double speed = layout_.largest_speed(y);
  // from rest: the speed that the acceleration reaches over the length
  const double reached =
      std::sqrt(length * accelerations.lpNorm<Eigen::Infinity>());
  speed_ = std::max({slowest_, speed_, speed, speed_ > 0.0 ? 0.0 : reached});
  // well above what steps may err by
  const double velocity_tolerance = 10.0 * tolerance_ * speed_;
  // clearly beyond what counts as rest
  const double break_free_speed =
      std::max(1e-3 * velocity_tolerance, 1e-8 * speed_);
  forces.set_velocity_tolerance(velocity_tolerance, break_free_speed, length,
                                slowest_ / length);
  lowest_pivot_ = std::min(lowest_pivot_, smallest_pivot);
}

void StateScales::put_scales(const VectorXd& y, const ForceModel& forces,
                             VectorXd& scales) const {
  const Index positions = layout_.velocity_index();
  scales.head(positions).setConstant(layout_.length());
  for (Index at = 3; !layout_.is_planar() && at < positions; at += 7) {
    scales.segment<4>(at).setConstant(0.5);  // of quaternions: a turn of 1
  }
  scales.segment(positions, layout_.velocities()).setConstant(speed_scale());
  forces.internal_scales(y.data() + layout_.internal_index(),
                         scales.data() + layout_.internal_index());
  scales[layout_.work_index()] = 0.0;
}

void StateScales::put_error_weights(const VectorXd& y, const ForceModel& forces,
                                    VectorXd& weights) const {
  put_scales(y, forces, weights);
  const double tolerance =
      std::max(tolerance_, std::min(kRoundOff / lowest_pivot_, kNearRank));
  weights.head(layout_.work_index()) =
      (tolerance * weights.head(layout_.work_index())).cwiseInverse();
}

}  // namespace clevis::mechanism
