#include "mechanism/joint_space/joint_coordinates.h"

#include <algorithm>
#include <utility>

#include "mechanism/dynamic_state/state_layout.h"

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
    const bool is_driven =
        std::ranges::find(drives, link.joint, &DriveDefinition::joint) !=
        drives.end();
    if (!result.add(link, is_driven)) return std::nullopt;
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

bool JointCoordinates::add(const TreeLink& given, bool is_driven) {
  Link link;
  link.slot = static_cast<std::size_t>(given.body + 1);
  link.joint = given.joint;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (static_cast<int>(links_[k].slot) == given.parent + 1) {
      link.parent = static_cast<int>(k);
      link.parent_slot = links_[k].slot;
    }
  }
  models_.push_back(model(link));
  const auto kind = joint_motion_kind(models_.back().type, frame_->planar);
  if (!kind) return false;
  link.kind =
      given.joint < 0 && !frame_->planar ? JointMotionKind::kFree : *kind;
  // axes of the inner body: those of the outer one may spin
  const bool has_axes = link.kind == JointMotionKind::kPlane ||
                        link.kind == JointMotionKind::kBall;
  JointModel& joint = models_.back();
  if (has_axes && !is_driven && joint.a == static_cast<int>(link.slot)) {
    std::swap(joint.a, joint.b);
    std::swap(joint.frame_a, joint.frame_b);
    link.reversed = true;
  }
  link.is_b = joint.b == static_cast<int>(link.slot);
  link.q = coordinates_;
  link.u = velocities_;
  link.count = link.open = velocity_count(link.kind);
  coordinates_ += coordinate_count(link.kind);
  velocities_ += link.count;
  links_.push_back(link);
  return true;
}

std::optional<JointCoordinates::Measured> JointCoordinates::measured(
    int joint, const JointRow& row) const {
  for (const Link& link : links_) {
    if (link.joint != joint) continue;
    const int at = measured_coordinate(link.kind, row);
    // directions in a plane differ from side to side
    const bool is_unclear = link.reversed && at != turn_coordinate(link.kind);
    if (at < 0 || is_unclear) return std::nullopt;
    return Measured{link.q + at, link.u + at, link.sense()};
  }
  return std::nullopt;
}

/// @return false if it does not prescribe a coordinate of its own.
bool JointCoordinates::drive(std::size_t k, const DriveDefinition& drive) {
  const JointRow row =
      coordinate_row(frame_->joints[static_cast<std::size_t>(drive.joint)].type,
                     drive.coordinate);
  const auto place = measured(drive.joint, row);
  if (!place) return false;
  const auto at = std::ranges::find(links_, drive.joint, &Link::joint);
  const int own = static_cast<int>(place->u - at->u);
  const auto open = at->order.begin() + at->open;
  const auto found = std::find(at->order.begin(), open, own);
  if (found == open) return false;  // twice
  std::rotate(found, found + 1, open);
  --at->open;
  driven_.push_back(
      {k, static_cast<std::size_t>(at - links_.begin()), place->q, place->u});
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

void JointCoordinates::place(const double* q, const double* u,
                             const double* u_rate, Configuration& x,
                             std::vector<Twist>& twists) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const Link& link = links_[k];
    place_link(link, models_[k], {q + link.q, u + link.u, u_rate + link.u}, x,
               twists, motions_[k]);
    if (frame_->planar) {
      x[link.slot].p.z() = frame_->placement[link.slot].p.z();
    }
    const int turn = turn_coordinate(link.kind);
    if (link.joint >= 0 && turn >= 0) {
      const double angle = q[link.q + turn];
      x.angles[static_cast<std::size_t>(link.joint)] = link.sense() * angle;
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
    // of free bodies the last one, all others are counted
    const double near =
        link.joint >= 0
            ? x.angle(static_cast<std::size_t>(link.joint)) * link.sense()
        : turn >= 0 ? q[link.q + turn]
                    : 0.0;
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
