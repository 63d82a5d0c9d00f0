#include "mechanism/joint_coordinates.h"

#include <algorithm>

#include "mechanism/forward_dynamics.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<JointCoordinates> JointCoordinates::of(
    const SolvingFrame& frame, const std::vector<DriveDefinition>& drives) {
  std::vector<TreeLink> links = tree_links(frame, {});
  if (links.empty()) return std::nullopt;
  std::ranges::reverse(links);
  JointCoordinates result(frame);
  for (const TreeLink& link : links) {
    if (!result.add(link)) return std::nullopt;
  }
  for (std::size_t k = 0; k < drives.size(); ++k) {
    if (!result.drive(k, drives[k])) return std::nullopt;
  }
  result.list_open();
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
  link.count = link.open = velocity_count(link.kind);
  coordinates_ += coordinate_count(link.kind);
  velocities_ += link.count;
  links_.push_back(link);
  return true;
}

Index JointCoordinates::velocity_of(int joint, const JointRow& row) const {
  for (const Link& link : links_) {
    if (link.joint != joint) continue;
    const int at = measured_coordinate(link.kind, row);
    return at < 0 ? -1 : link.u + at;
  }
  return -1;
}

/// @return false if it does not prescribe a coordinate of its own.
bool JointCoordinates::drive(std::size_t k, const DriveDefinition& drive) {
  const JointRow row =
      coordinate_row(frame_->joints[static_cast<std::size_t>(drive.joint)].type,
                     drive.coordinate);
  const Index u = velocity_of(drive.joint, row);
  if (u < 0) return false;
  const auto at = std::ranges::find(links_, drive.joint, &Link::joint);
  const int own = static_cast<int>(u - at->u);
  const auto open = at->order.begin() + at->open;
  const auto found = std::find(at->order.begin(), open, own);
  if (found == open) return false;  // twice
  std::rotate(found, found + 1, open);
  --at->open;
  driven_.push_back(
      {k, static_cast<std::size_t>(at - links_.begin()), at->q + own, u});
  return true;
}

void JointCoordinates::list_open() {
  for (Index i = 0; i < coordinates_; ++i) {
    if (std::ranges::find(driven_, i, &Driven::q) == driven_.end()) {
      open_q_.push_back(i);
    }
  }
  for (Index i = 0; i < velocities_; ++i) {
    if (std::ranges::find(driven_, i, &Driven::u) == driven_.end()) {
      open_u_.push_back(i);
    }
  }
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
