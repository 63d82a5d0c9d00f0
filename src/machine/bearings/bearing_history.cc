#include "machine/bearings/bearing_history.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <Eigen/Geometry>

namespace clevis::machine {
namespace {

using Eigen::Vector3d;
using mechanism::BodyIndex;
using mechanism::Instant;

Vector3d angular_velocity(BodyIndex body, const Instant& instant) {
  return body == mechanism::kGround
             ? Vector3d(Vector3d::Zero())
             : instant.bodies[static_cast<std::size_t>(body)].w_WL;
}

Eigen::Matrix3d orientation(BodyIndex body, const Instant& instant) {
  return body == mechanism::kGround
             ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
             : instant.bodies[static_cast<std::size_t>(body)].pose.R_WL;
}

/// The instants, those that repeat others, and the change points between them
/// where joints that give way hold the loads.
std::vector<const Instant*> in_time(const mechanism::Motion& motion) {
  std::vector<const Instant*> instants;
  for (const Instant& instant : motion.instants) instants.push_back(&instant);
  for (const Instant& instant : motion.repeats) instants.push_back(&instant);
  for (const auto& point : motion.change_points) {
    if (point.at) instants.push_back(&*point.at);
  }
  std::ranges::stable_sort(instants, {}, &Instant::t);
  return instants;
}

}  // namespace

std::vector<BearingInstant> bearing_history(
    const BearingDefinition& bearing,
    const mechanism::MechanismDefinition& mechanism,
    const mechanism::Motion& motion) {
  const auto j = static_cast<std::size_t>(bearing.joint);
  const mechanism::JointDefinition& joint = mechanism.joints[j];
  std::vector<BearingInstant> history;
  std::optional<Vector3d> mark;  // across the axis, on body b
  for (const Instant* each : in_time(motion)) {
    const Instant& instant = *each;
    const mechanism::JointReaction& reaction = instant.joints[j];
    const Vector3d z = reaction.R_WJ.col(2);
    const double axial = reaction.f_W.dot(z);
    BearingInstant here;
    here.t = instant.t;
    here.axial = std::abs(axial);
    here.radial = (reaction.f_W - axial * z).norm();
    here.tilt = (reaction.t_W - reaction.t_W.dot(z) * z).norm();
    here.speed = (angular_velocity(joint.body_b, instant) -
                  angular_velocity(joint.body_a, instant))
                     .dot(z);
    const Eigen::Matrix3d R_WB = orientation(joint.body_b, instant);
    const Vector3d x = reaction.R_WJ.col(0);
    if (!mark) mark = R_WB.transpose() * x;
    const Vector3d turned = R_WB * *mark;
    here.angle = std::atan2(z.dot(x.cross(turned)), x.dot(turned));
    here.unique =
        std::all_of(reaction.unique_components.begin(),
                    reaction.unique_components.begin() + 3, std::identity{});
    history.push_back(here);
  }
  return history;
}

}  // namespace clevis::machine
