#include "mechanism/joint_coordinates.h"

#include <algorithm>

#include "mechanism/forward_dynamics.h"

namespace clevis::mechanism {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<JointCoordinates> JointCoordinates::of(
    const SolvingFrame& frame) {
  std::vector<TreeLink> links = tree_links(frame, {});
  if (links.empty()) return std::nullopt;
  std::ranges::reverse(links);
  JointCoordinates result(frame);
  for (const TreeLink& link : links) {
    if (!result.add(link)) return std::nullopt;
  }
  result.motions_.resize(links.size());
  return result;
}

/// A free body is b of a joint from the ground whose frames are its own.
JointModel JointCoordinates::model(const Link& link) const {
  if (link.joint >= 0) {
    return frame_->joints[static_cast<std::size_t>(link.joint)];
  }
  JointModel model;
  model.type = JointType::kPlanar;
  model.b = static_cast<int>(link.slot);
  return model;
}

bool JointCoordinates::add(const TreeLink& given) {
  Link link;
  link.slot = static_cast<std::size_t>(given.body + 1);
  link.joint = given.joint;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (static_cast<int>(links_[k].slot) == given.parent + 1) {
      link.parent = static_cast<int>(k);
    }
  }
  models_.push_back(model(link));
  const auto kind = joint_motion_kind(models_.back().type, frame_->planar);
  if (!kind) return false;
  link.kind =
      given.joint < 0 && !frame_->planar ? JointMotionKind::kFree : *kind;
  link.is_b = models_.back().b == static_cast<int>(link.slot);
  link.q = coordinates_;
  link.u = velocities_;
  link.count = velocity_count(link.kind);
  coordinates_ += coordinate_count(link.kind);
  velocities_ += link.count;
  links_.push_back(link);
  return true;
}

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

/// @return velocity of J on b against a.
Twist JointCoordinates::put_directions(std::size_t k, const Joint& joint,
                                       const JointMotion& relative,
                                       const double* u) {
  const Link& link = links_[k];
  const Vector3d& lever = link.is_b ? joint.from_b : joint.from_a;
  const double sign = link.is_b ? 1.0 : -1.0;
  Twist rate;
  for (std::size_t j = 0; j < static_cast<std::size_t>(link.count); ++j) {
    const Vector3d e = joint.axes_a * relative.directions[j].v;
    const Vector3d s = joint.axes_a * relative.directions[j].w;
    rate.v += u[j] * e;
    rate.w += u[j] * s;
    motions_[k].S[j] = {sign * (e - s.cross(lever)), sign * s};
  }
  return rate;
}

/// @param rate  of J on b against a. @param turning  see JointMotion, in P.
void JointCoordinates::put_velocities(std::size_t k, const Joint& joint,
                                      const Twist& rate,
                                      const Vector3d& turning,
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
  motion.bias.w = sign * (w_a.cross(rate.w) + turning);
  motion.bias.v = sign * (w_a.cross(w_a.cross(joint.from_a) + 2.0 * rate.v) -
                          w_b.cross(w_b.cross(joint.from_b))) -
                  motion.bias.w.cross(lever);
}

void JointCoordinates::place(const double* q, const double* u, Configuration& x,
                             std::vector<Twist>& twists) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const Link& link = links_[k];
    JointMotion relative;
    relative.set(link.kind, models_[k].slide_per_angle, q + link.q, u + link.u);
    const Joint joint = place_body(k, relative, x);
    const Twist rate = put_directions(k, joint, relative, u + link.u);
    put_velocities(k, joint, rate, joint.axes_a * relative.turning, twists);
    const int turn = turn_coordinate(link.kind);
    if (models_[k].counts_turns && turn >= 0) {
      x.angles[static_cast<std::size_t>(link.joint)] = q[link.q + turn];
    }
  }
}

void JointCoordinates::read(const Configuration& x,
                            const std::vector<Twist>& twists, double* q,
                            double* u) const {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const Link& link = links_[k];
    const JointModel& joint = models_[k];
    const auto a = static_cast<std::size_t>(joint.a);
    const auto b = static_cast<std::size_t>(joint.b);
    const int turn = turn_coordinate(link.kind);
    const double near = link.joint < 0 || !joint.counts_turns
                            ? (turn < 0 ? 0.0 : q[link.q + turn])
                            : x.angle(static_cast<std::size_t>(link.joint));
    const PlacedJoint placed(joint, x[a], x[b], near);
    const Matrix3d to_a = placed.axes_a.transpose();
    JointMotion relative;
    relative.R_ab = to_a * placed.axes_b;
    relative.d = to_a * placed.d;
    const Vector3d arm = placed.r_a + placed.d;
    const Twist twist{to_a * (twists[b].v + twists[b].w.cross(placed.r_b) -
                              twists[a].v - twists[a].w.cross(arm)),
                      to_a * (twists[b].w - twists[a].w)};
    read_joint_motion(link.kind, relative, twist,
                      turn < 0 ? 0.0 : placed.turned(), q + link.q, u + link.u);
  }
}

void JointCoordinates::rates(const double* q, const double* u,
                             double* rates) const {
  for (const Link& link : links_) {
    const int first = quaternion_coordinate(link.kind);
    const int scalars = first < 0 ? link.count : first;
    std::copy_n(u + link.u, scalars, rates + link.q);
    if (first < 0) continue;
    const Eigen::Map<const Vector3d> w(u + link.u + first);
    Eigen::Map<Eigen::Vector4d>(rates + link.q + first) = quaternion_rate(
        Eigen::Map<const Eigen::Vector4d>(q + link.q + first), 0.5 * w);
  }
}

}  // namespace clevis::mechanism
