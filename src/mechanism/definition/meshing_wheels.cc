#include "mechanism/definition/meshing_wheels.h"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace clevis::mechanism {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kRoundOff = 1e-6;  // of directions, and of lengths over others
constexpr double kLeastDistance = 1e-6;  // of axes [m]

const JointDefinition& joint_at(const std::vector<JointDefinition>& joints,
                                int index) {
  return joints[static_cast<std::size_t>(index)];
}

/// Frame J on a body, in its L.
Isometry3d frame_on(const JointDefinition& joint, BodyIndex body) {
  const JointFrame& frame =
      joint.body_b == body ? joint.frame_b : joint.frame_a;
  Isometry3d X_LJ = Isometry3d::Identity();
  X_LJ.linear() = frame.R_LJ;
  X_LJ.translation() = frame.p_LJ;
  return X_LJ;
}

/// Frames L of a body and all that welds join to it, in its own.
std::map<BodyIndex, Isometry3d> welded_to(
    const std::vector<JointDefinition>& joints, BodyIndex body) {
  std::map<BodyIndex, Isometry3d> found{{body, Isometry3d::Identity()}};
  for (bool grown = true; grown;) {
    grown = false;
    for (const JointDefinition& joint : joints) {
      if (joint.type != JointType::kWeld ||
          found.contains(joint.body_a) == found.contains(joint.body_b)) {
        continue;
      }
      const bool has_a = found.contains(joint.body_a);
      const BodyIndex known = has_a ? joint.body_a : joint.body_b;
      const BodyIndex next = has_a ? joint.body_b : joint.body_a;
      found[next] = found[known] * frame_on(joint, known) *
                    frame_on(joint, next).inverse();
      grown = true;
    }
  }
  return found;
}

/// Axes of a coupling's joints, z of their frames, in L of the first carrier.
struct Axes {
  Vector3d point_1, point_2;
  Vector3d along_1, along_2;

  double along() const { return (point_2 - point_1).dot(along_1); }
  double distance() const {
    return (point_2 - point_1 - along() * along_1).norm();
  }
};

Axes axes_of(const std::vector<JointDefinition>& joints,
             const CouplingDefinition& coupling, const MeshingWheels& wheels) {
  const Isometry3d one =
      frame_on(joint_at(joints, coupling.joint_1), wheels.carrier_1);
  const Isometry3d two =
      welded_to(joints, wheels.carrier_1).at(wheels.carrier_2) *
      frame_on(joint_at(joints, coupling.joint_2), wheels.carrier_2);
  return {.point_1 = one.translation(),
          .point_2 = two.translation(),
          .along_1 = one.linear().col(2),
          .along_2 = two.linear().col(2)};
}

/// Speed of wheel 1 about its axis over that of wheel 2 about the same
/// direction, as their carriers see them.
double ratio_of_speeds(const std::vector<JointDefinition>& joints,
                       const CouplingDefinition& coupling,
                       const MeshingWheels& wheels, const Axes& axes) {
  const bool same_sense = axes.along_1.dot(axes.along_2) > 0.0;
  const bool same_side =
      (joint_at(joints, coupling.joint_1).body_b == wheels.wheel_1) ==
      (joint_at(joints, coupling.joint_2).body_b == wheels.wheel_2);
  return same_sense == same_side ? coupling.ratio : -coupling.ratio;
}

std::optional<ToothMisfit> misfit_of_gears(
    const std::vector<JointDefinition>& joints,
    const CouplingDefinition& coupling, const MeshingWheels& wheels,
    const Axes& axes) {
  if (axes.along_1.cross(axes.along_2).norm() > kRoundOff) {
    return ToothMisfit{
        "is given for wheels whose axes are not parallel",
        "Only the teeth of parallel axes, and of a rack, are resolved: leave "
        "`pressure_angle` out."};
  }
  const double way = (axes.point_2 - axes.point_1).norm();
  if (!(axes.distance() > std::max(kRoundOff * way, kLeastDistance))) {
    return ToothMisfit{"is given for wheels on one axis",
                       "Move the joints' points to the two axes."};
  }
  if (!coupling.teeth->mid_face &&
      std::abs(axes.along()) > kRoundOff * axes.distance()) {
    return ToothMisfit{
        fmt::format("does not say where the teeth mesh: the points of the "
                    "joints lie {:.6g} mm apart along the axes",
                    1e3 * std::abs(axes.along())),
        "Give `mid_face`, the middle of the face width from the point of the "
        "first joint along its axis."};
  }
  if (std::abs(ratio_of_speeds(joints, coupling, wheels, axes) - 1.0) <=
      kRoundOff) {
    return ToothMisfit{
        "is given for wheels that turn as one: a ring and its pinion cannot "
        "be alike",
        "Give a negative `ratio` for an external mesh."};
  }
  return std::nullopt;
}

}  // namespace

std::optional<MeshingWheels> meshing_wheels(
    const std::vector<JointDefinition>& joints,
    const CouplingDefinition& coupling) {
  const JointDefinition& one = joint_at(joints, coupling.joint_1);
  const JointDefinition& two = joint_at(joints, coupling.joint_2);
  std::optional<MeshingWheels> found;
  for (const auto& [wheel_1, carrier_1] :
       {std::pair{one.body_b, one.body_a}, std::pair{one.body_a, one.body_b}}) {
    const auto carriers = welded_to(joints, carrier_1);
    for (const auto& [wheel_2, carrier_2] :
         {std::pair{two.body_b, two.body_a},
          std::pair{two.body_a, two.body_b}}) {
      if (!carriers.contains(carrier_2)) continue;
      if (found || carriers.contains(wheel_1) || carriers.contains(wheel_2)) {
        return std::nullopt;
      }
      found = {.wheel_1 = wheel_1,
               .wheel_2 = wheel_2,
               .carrier_1 = carrier_1,
               .carrier_2 = carrier_2};
    }
  }
  return found;
}

PitchCircles pitch_circles(const std::vector<JointDefinition>& joints,
                           const CouplingDefinition& coupling) {
  const MeshingWheels wheels = *meshing_wheels(joints, coupling);
  const Axes axes = axes_of(joints, coupling, wheels);
  const double distance = axes.distance();
  // Both wheels are equally fast at the pitch point.
  const double speeds = ratio_of_speeds(joints, coupling, wheels, axes);
  return {.distance = distance, .to_pitch = distance / (1.0 - speeds)};
}

std::optional<ToothMisfit> tooth_misfit(
    const std::vector<JointDefinition>& joints,
    const CouplingDefinition& coupling) {
  const JointDefinition& one = joint_at(joints, coupling.joint_1);
  const JointDefinition& two = joint_at(joints, coupling.joint_2);
  const bool is_gear = one.type == JointType::kRevolute;
  if ((!is_gear && one.type != JointType::kPrismatic) ||
      two.type != JointType::kRevolute) {
    return ToothMisfit{
        "is given for joints that let wheels or racks move otherwise",
        "Couple two revolute joints, or a prismatic with a revolute one, or "
        "leave `pressure_angle` out."};
  }
  const auto wheels = meshing_wheels(joints, coupling);
  if (!wheels) {
    return ToothMisfit{
        fmt::format("is given, but joints \"{}\" and \"{}\" have no body in "
                    "common that carries both wheels, nor bodies that welds "
                    "join",
                    one.name, two.name),
        "Let both joints lead to one body, as the ground or a housing."};
  }
  const Axes axes = axes_of(joints, coupling, *wheels);
  if (is_gear) return misfit_of_gears(joints, coupling, *wheels, axes);
  if (std::abs(axes.along_1.dot(axes.along_2)) > kRoundOff) {
    return ToothMisfit{
        "is given for a rack that does not slide across the pinion's axis",
        "Turn the slide's axis across the pinion's."};
  }
  return std::nullopt;
}

}  // namespace clevis::mechanism
