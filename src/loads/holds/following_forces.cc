#include "loads/holds/following_forces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include <Eigen/Geometry>

#include "mechanism/joints/joint_types.h"

namespace clevis::loads {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanism::BodyIndex;
using mechanism::JointDefinition;
using mechanism::JointType;

/// Of a force, across its line: what else acts on a link.
constexpr double kAcross = 0.05;

Vector3d origin_of(const JointDefinition& joint, BodyIndex body,
                   const mechanism::Instant& instant) {
  const auto& frame = joint.body_a == body ? joint.frame_a : joint.frame_b;
  if (body == mechanism::kGround) return frame.p_LJ;
  const auto& pose = instant.bodies[static_cast<std::size_t>(body)].pose;
  return pose.p_WL + pose.R_WL * frame.p_LJ;
}

/// Directions across a line in which a joint lets a link swing; nothing: in
/// none.
std::optional<Matrix3d> swings(const JointDefinition& joint,
                               const mechanism::JointReaction& reaction,
                               const Vector3d& along) {
  constexpr double kParallel = 0.1;
  const mechanism::JointTraits& kind = mechanism::traits(joint.type);
  const auto angles = std::ranges::count_if(
      kind.coordinates, [](const mechanism::JointCoordinate& coordinate) {
        return coordinate.row.is_angle();
      });
  if (kind.slides()) return std::nullopt;
  if (angles > 1 || joint.type == JointType::kDistance) {
    return Matrix3d(Matrix3d::Identity() - along * along.transpose());
  }
  const Vector3d across = reaction.R_WJ.col(2).cross(along);
  if (angles == 0 || across.norm() < kParallel) return std::nullopt;
  return Matrix3d(across.normalized() * across.normalized().transpose());
}

/// @param force  on the part, at `from`. @param to  where its line goes
/// through.
std::optional<Matrix3d> gain(const Vector3d& force, const Vector3d& from,
                             const Vector3d& to) {
  const Vector3d line = to - from;
  const double length = line.norm();
  if (!(length > 0.0) || !(force.norm() > 0.0)) return std::nullopt;
  const Vector3d along = line / length;
  const double pressing = -force.dot(along);
  if ((force + pressing * along).norm() > kAcross * force.norm()) {
    return std::nullopt;
  }
  return Matrix3d(pressing / length *
                  (Matrix3d::Identity() - along * along.transpose()));
}

/// The link's other joint, if it has two and no force acts on it.
std::optional<std::size_t> other_joint(
    const mechanism::MechanismDefinition& definition, BodyIndex link,
    std::size_t joint) {
  std::optional<std::size_t> other;
  for (std::size_t k = 0; k < definition.joints.size(); ++k) {
    const JointDefinition& one = definition.joints[k];
    if (k == joint || (one.body_a != link && one.body_b != link)) continue;
    if (other) return std::nullopt;
    other = k;
  }
  for (const auto& element : definition.elements) {
    if (mechanism::acts_on(element, definition.joints, link)) {
      return std::nullopt;
    }
  }
  return other;
}

std::optional<Matrix3d> gain_of_joint(const SeatContext& context,
                                      const mechanism::Instant& instant,
                                      const JointSeat& seat) {
  const JointDefinition& joint = *seat.joint.definition;
  const auto& reaction = instant.joints[seat.joint.index];
  const BodyIndex link =
      joint.body_a == context.body ? joint.body_b : joint.body_a;
  const Vector3d from = origin_of(joint, context.body, instant);
  const Vector3d force = seat.joint.sign * reaction.f_W;
  if (joint.type == JointType::kDistance) {
    return gain(force, from, origin_of(joint, link, instant));
  }
  if (link == mechanism::kGround) return std::nullopt;
  const auto other = other_joint(context.definition, link, seat.joint.index);
  if (!other) return std::nullopt;
  const JointDefinition& far = context.definition.joints[*other];
  const Vector3d to = origin_of(far, link, instant);
  const auto whole = gain(force, from, to);
  if (!whole) return std::nullopt;
  const Vector3d along = (to - from).normalized();
  const auto here = swings(joint, reaction, along);
  const auto there = swings(far, instant.joints[*other], along);
  if (!here || !there) return std::nullopt;
  return Matrix3d(*here * *there * *whole * *there * *here);
}

std::optional<Matrix3d> gain_of_force(const SeatContext& context,
                                      const mechanism::Instant& instant,
                                      const ForceSeat& seat) {
  const auto* line = std::get_if<mechanism::LineElement>(
      &context.definition.elements[seat.index]);
  if (line == nullptr ||
      line->line.kind != mechanism::ElementLine::Kind::kDistance) {
    return std::nullopt;
  }
  const auto& actions = instant.elements[seat.index].actions;
  const bool is_first = actions[0].body == context.body;
  const auto& own = actions[is_first ? 0 : 1];
  return gain(own.f_W, own.p_W, actions[is_first ? 1 : 0].p_W);
}

}  // namespace

std::vector<FollowingForce> following_forces(
    const SeatContext& context, const mechanism::Instant& instant,
    const std::vector<JointSeat>& by_joint,
    const std::vector<ForceSeat>& by_force, std::size_t first_force) {
  std::vector<FollowingForce> found;
  const Matrix3d R_WL =
      instant.bodies[static_cast<std::size_t>(context.body)].pose.R_WL;
  const auto add = [&](std::size_t seat, const std::optional<Matrix3d>& gain) {
    if (gain) found.push_back({seat, R_WL.transpose() * *gain * R_WL});
  };
  for (std::size_t s = 0; s < by_joint.size(); ++s) {
    add(s, gain_of_joint(context, instant, by_joint[s]));
  }
  for (std::size_t s = 0; s < by_force.size(); ++s) {
    add(first_force + s, gain_of_force(context, instant, by_force[s]));
  }
  return found;
}

}  // namespace clevis::loads
