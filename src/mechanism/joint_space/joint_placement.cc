// Bodies of a tree where the coordinates of its joints put them.
#include "mechanism/joint_space/joint_coordinates.h"

namespace clevis::mechanism {

using Eigen::Vector3d;

/// Places the body behind a joint. @return the joint, placed.
JointCoordinates::Joint JointCoordinates::place_body(
    std::size_t k, const JointMotion& relative, Configuration& x) {
  const Link& link = links_[k];
  const JointModel& model = models_[k];
  const BodyPlacement& parent = x[parent_slot(link)];
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
  Vector3d& shift = motions_[k].shift;
  shift = joint.from_a - joint.from_b;
  if (!link.is_b) shift = -shift;
  body.p = parent.p + shift;
  if (frame_->planar) body.p.z() = frame_->placement[link.slot].p.z();
  return joint;
}

/// @param driven  acceleration of J on b against a by drives, and by the turn
///   of directions, is filled. @return its velocity.
Twist JointCoordinates::put_directions(std::size_t k, const Joint& joint,
                                       const JointMotion& relative,
                                       const double* u, const double* u_rate,
                                       Twist& driven) {
  const Link& link = links_[k];
  const Vector3d& lever = link.is_b ? joint.from_b : joint.from_a;
  const double sign = link.is_b ? 1.0 : -1.0;
  Twist rate;
  driven = {Vector3d::Zero(), joint.axes_a * relative.turning};
  for (int j = 0; j < link.count; ++j) {
    const int own = link.order[static_cast<std::size_t>(j)];
    const Twist& direction = relative.directions[static_cast<std::size_t>(own)];
    const Vector3d e = joint.axes_a * direction.v;
    const Vector3d s = joint.axes_a * direction.w;
    rate.v += u[own] * e;
    rate.w += u[own] * s;
    if (j >= link.open) {
      driven.v += u_rate[own] * e;
      driven.w += u_rate[own] * s;
    }
    motions_[k].S[static_cast<std::size_t>(j)] = {sign * (e - s.cross(lever)),
                                                  sign * s};
  }
  return rate;
}

/// @param rate, driven  of put_directions().
void JointCoordinates::put_velocities(std::size_t k, const Joint& joint,
                                      const Twist& rate, const Twist& driven,
                                      std::vector<Twist>& twists) {
  const Link& link = links_[k];
  Motion& motion = motions_[k];
  const Twist& parent = twists[parent_slot(link)];
  Twist& body = twists[link.slot];
  const Vector3d& lever = link.is_b ? joint.from_b : joint.from_a;
  const double sign = link.is_b ? 1.0 : -1.0;
  body.w = parent.w + sign * rate.w;
  body.v = parent.v + parent.w.cross(motion.shift) +
           sign * (rate.v - rate.w.cross(lever));
  const Vector3d& w_a = link.is_b ? parent.w : body.w;
  const Vector3d& w_b = link.is_b ? body.w : parent.w;
  motion.bias.w = sign * (w_a.cross(rate.w) + driven.w);
  motion.bias.v = sign * (w_a.cross(w_a.cross(joint.from_a) + 2.0 * rate.v) -
                          w_b.cross(w_b.cross(joint.from_b)) + driven.v) -
                  motion.bias.w.cross(lever);
}

void JointCoordinates::place(const double* q, const double* u,
                             const double* u_rate, Configuration& x,
                             std::vector<Twist>& twists) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const Link& link = links_[k];
    JointMotion relative;
    relative.set(link.kind, models_[k].slide_per_angle, q + link.q, u + link.u);
    const Joint joint = place_body(k, relative, x);
    Twist driven;
    const Twist rate =
        put_directions(k, joint, relative, u + link.u, u_rate + link.u, driven);
    put_velocities(k, joint, rate, driven, twists);
    const int turn = turn_coordinate(link.kind);
    if (link.joint >= 0 && turn >= 0) {
      const double angle = q[link.q + turn];
      x.angles[static_cast<std::size_t>(link.joint)] = link.sense() * angle;
    }
  }
}

}  // namespace clevis::mechanism
