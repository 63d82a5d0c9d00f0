#include "mechanism/joint_space/joint_placement.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

/// A joint where its coordinates put it.
struct Joint {
  Eigen::Matrix3d axes_a;
  Vector3d from_a, from_b;  ///< to J on b from the centres of mass [m]
};

/// Motion of J on b against a.
struct RelativeMotion {
  Twist rate;
  Twist driven;  ///< acceleration by drives, and by the turn of directions
};

/// Places the body behind a joint. @param shift  from the parent to it, filled.
Joint place_body(const JointLink& link, const JointModel& model,
                 const JointMotion& relative, Configuration& x,
                 Vector3d& shift) {
  const BodyPlacement& parent = x[link.parent_slot];
  BodyPlacement& body = x[link.slot];
  Joint joint;
  if (link.is_b) {
    joint.axes_a.noalias() = parent.R * model.frame_a.R_LJ;
    body.R.noalias() =
        joint.axes_a * relative.R_ab * model.frame_b.R_LJ.transpose();
  } else {
    joint.axes_a.noalias() =
        parent.R * model.frame_b.R_LJ * relative.R_ab.transpose();
    body.R.noalias() = joint.axes_a * model.frame_a.R_LJ.transpose();
  }
  const BodyPlacement& a = link.is_b ? parent : body;
  const BodyPlacement& b = link.is_b ? body : parent;
  joint.from_a = a.R * model.frame_a.p_LJ + joint.axes_a * relative.d;
  joint.from_b = b.R * model.frame_b.p_LJ;
  shift = joint.from_a - joint.from_b;
  if (!link.is_b) shift = -shift;
  body.p = parent.p + shift;
  return joint;
}

/// Directions of the joint's velocities, at the body's centre of mass.
RelativeMotion put_directions(const JointLink& link, const Joint& joint,
                              const JointMotion& relative,
                              const JointValues& values, LinkMotion& motion) {
  const Vector3d& lever = link.is_b ? joint.from_b : joint.from_a;
  const double sign = link.is_b ? 1.0 : -1.0;
  RelativeMotion result{
      .rate = {},
      .driven = {Vector3d::Zero(), joint.axes_a * relative.turning}};
  for (int j = 0; j < link.count; ++j) {
    const int own = link.order[static_cast<std::size_t>(j)];
    const Twist& direction = relative.directions[static_cast<std::size_t>(own)];
    const Vector3d e = joint.axes_a * direction.v;
    const Vector3d s = joint.axes_a * direction.w;
    result.rate.v += values.u[own] * e;
    result.rate.w += values.u[own] * s;
    if (j >= link.open) {
      result.driven.v += values.u_rate[own] * e;
      result.driven.w += values.u_rate[own] * s;
    }
    motion.S[static_cast<std::size_t>(j)] = {sign * (e - s.cross(lever)),
                                             sign * s};
  }
  return result;
}

void put_velocities(const JointLink& link, const Joint& joint,
                    const RelativeMotion& relative, std::vector<Twist>& twists,
                    LinkMotion& motion) {
  const Twist& rate = relative.rate;
  const Twist& parent = twists[link.parent_slot];
  Twist& body = twists[link.slot];
  const Vector3d& lever = link.is_b ? joint.from_b : joint.from_a;
  const double sign = link.is_b ? 1.0 : -1.0;
  body.w = parent.w + sign * rate.w;
  body.v = parent.v + parent.w.cross(motion.shift) +
           sign * (rate.v - rate.w.cross(lever));
  const Vector3d& w_a = link.is_b ? parent.w : body.w;
  const Vector3d& w_b = link.is_b ? body.w : parent.w;
  motion.bias.w = sign * (w_a.cross(rate.w) + relative.driven.w);
  motion.bias.v =
      sign * (w_a.cross(w_a.cross(joint.from_a) + 2.0 * rate.v) -
              w_b.cross(w_b.cross(joint.from_b)) + relative.driven.v) -
      motion.bias.w.cross(lever);
}

}  // namespace

void place_link(const JointLink& link, const JointModel& model,
                const JointValues& values, Configuration& x,
                std::vector<Twist>& twists, LinkMotion& motion) {
  JointMotion relative;
  relative.set(link.kind, model.slide_per_angle, values.q, values.u);
  const Joint joint = place_body(link, model, relative, x, motion.shift);
  put_velocities(link, joint,
                 put_directions(link, joint, relative, values, motion), twists,
                 motion);
}

}  // namespace clevis::mechanism
