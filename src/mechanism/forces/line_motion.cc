#include "mechanism/forces/line_motion.h"

#include "base/values/index.h"

namespace clevis::mechanism {

double line_bias(const ActingElement& e, const ElementResponse& now,
                 const std::vector<Twist>& twists) {
  return now.placed.bias(e.row, twists[index(e.line.a)],
                         twists[index(e.line.b)]);
}

double line_acceleration(const ActingElement& e, const ElementResponse& now,
                         const std::vector<SpatialAcceleration>& accelerations,
                         const std::vector<Twist>& twists) {
  const Twist& a = accelerations[index(e.line.a)];
  const Twist& b = accelerations[index(e.line.b)];
  const PlacedJoint::Levers& levers = now.levers;
  return levers.a.v.dot(a.v) + levers.a.w.dot(a.w) + levers.b.v.dot(b.v) +
         levers.b.w.dot(b.w) + line_bias(e, now, twists);
}

double sliding_acceleration(
    const ActingElement& e, const ElementResponse& now,
    const std::vector<SpatialAcceleration>& accelerations) {
  return e.sliding_acceleration(now, accelerations[index(e.line.a)],
                                accelerations[index(e.line.b)]);
}

double joint_rate(const ActingElement& e,
                  const std::vector<PlacedJoint>& placed,
                  const std::vector<Twist>& twists) {
  const Eigen::Vector3d axis = placed[index(e.joint)].axes_a.col(2);
  return axis.dot(twists[index(e.line.b)].w - twists[index(e.line.a)].w);
}

bool counts_turns(const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).line.counts_turns) return true;
  }
  return false;
}

}  // namespace clevis::mechanism
