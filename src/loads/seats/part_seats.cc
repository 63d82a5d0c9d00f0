#include "loads/seats/part_seats.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/seats/seat_fit.h"
#include "loads/seats/slide_zone.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/definition/meshing_wheels.h"
#include "mechanism/joints/joint_types.h"
#include "mechanism/structure/tooth_paths.h"

namespace clevis::loads {

using Eigen::Vector3d;

namespace {

// Between the sums of a group's areas, relative to its area.
constexpr double kClosedTolerance = 1e-6;

BodyJoint body_joint(const SeatContext& context, const std::string& name,
                     const std::string& place) {
  const auto& joints = context.definition.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const mechanism::JointDefinition& joint = joints[i];
    if (joint.name != name) continue;
    if (joint.body_b == context.body) return {i, &joint, &joint.frame_b, 1.0};
    if (joint.body_a == context.body) return {i, &joint, &joint.frame_a, -1.0};
  }
  throw Error("L004", place,
              fmt::format("joint \"{}\" is not on the body of the part", name),
              "Name a joint that connects this body, or delete the entry.");
}

/// Seat of a joint: a pin's cylinder, a slide's wall, or for joints that
/// hold as welds do a face.
Seat joint_seat(const SeatContext& context, const part::Seat& wanted,
                const BodyJoint& joint) {
  const std::string place = context.place("joint " + wanted.joint);
  const GroupGeometry& group = find_group(context.groups, wanted.group, place);
  const auto& type = mechanism::traits(joint.definition->type);
  Seat seat{.name = wanted.joint, .group = wanted.group};
  if (type.slides()) seat.slide = slide_wall(context, wanted, joint);
  if (!group.is_cylinder && !type.needs_cylinder) {
    seat.kind = SeatKind::kTraction;
    seat.p_LS = group.centroid;
    if (!seat.slide || seat.slide->opposite.empty()) return seat;
    const GroupGeometry& other =
        find_group(context.groups, seat.slide->opposite, place);
    seat.p_LS = (group.area * group.centroid + other.area * other.centroid) /
                (group.area + other.area);
    return seat;
  }
  require_cylinder(group, place);
  seat.kind = SeatKind::kBearing;
  seat.p_LS = group.cylinder.p_LC;
  return seat;
}

// A pressure that is only the effort over the face's area acts on nothing
// else, so what it does to the other groups must cancel.
GroupGeometry pressurized_group(const SeatContext& context,
                                const std::string& name,
                                const std::string& place) {
  const GroupGeometry& group = find_group(context.groups, name, place);
  if (group.area_vector.norm() > kClosedTolerance * group.area) {
    throw Error(
        "L002", place,
        fmt::format("pressure on \"{}\" would leave a force: its area "
                    "vector is {} mm^2",
                    name,
                    vector_text(group.area_vector * 1e6, group.area * 1e6)),
        "Pressurize a wall that is closed all round; the drive's own "
        "force belongs to its `face`.");
  }
  return group;
}

/// Of a wheel, whose teeth travel round it, and of what carries wheels whose
/// teeth are not resolved.
[[noreturn]] void refuse_teeth(const SeatContext& context,
                               const mechanism::CouplingDefinition& coupling,
                               const mechanism::JointDefinition& joint) {
  throw Error(
      "L004", context.place("seats"),
      fmt::format("the teeth of coupling \"{}\" act on the part by joint "
                  "\"{}\": no face takes their force{}",
                  coupling.name, joint.name,
                  coupling.teeth ? "" : ", which is not resolved"),
      fmt::format("If the part is a wheel, or a shaft with one, give the wheel "
                  "a body of its own with that joint, welded to the part: pins "
                  "= {{ WELD = \"face\" }}{}; else check the part by a "
                  "[[part.history]] with the forces on its teeth.",
                  coupling.teeth ? ""
                                 : "; and give the coupling its "
                                   "`pressure_angle`"));
}

}  // namespace

std::vector<GroupGeometry> pressurized_groups(
    const SeatContext& context, const std::vector<std::string>& names,
    const std::string& place) {
  std::vector<GroupGeometry> groups;
  for (const std::string& name : names) {
    groups.push_back(pressurized_group(context, name, place));
  }
  return groups;
}

std::vector<JointSeat> joint_seats(const SeatContext& context) {
  std::vector<JointSeat> seats;
  for (const part::Seat& wanted : context.part.seats) {
    const BodyJoint joint = body_joint(context, wanted.joint,
                                       context.place("joint " + wanted.joint));
    seats.push_back({joint, joint_seat(context, wanted, joint)});
  }
  require_fit(context, seats);
  return seats;
}

std::vector<DrivenSeat> driven_seats(const SeatContext& context) {
  std::vector<DrivenSeat> seats;
  const auto& drives = context.definition.drives;
  for (const part::DriveSeat& wanted : context.part.drive_seats) {
    const std::string place = context.place("drive " + wanted.drive);
    const BodyJoint joint = body_joint(context, wanted.drive, place);
    const auto count = std::ranges::count(drives, static_cast<int>(joint.index),
                                          &mechanism::DriveDefinition::joint);
    if (count == 0) {
      throw Error("L004", place,
                  fmt::format("joint \"{}\" has no drive", wanted.drive),
                  "Name a driven joint, or delete the entry under `drives`.");
    }
    const GroupGeometry& face = find_group(context.groups, wanted.group, place);
    const auto pressurized =
        pressurized_groups(context, wanted.pressurized, place);
    for (std::size_t d = 0; d < drives.size(); ++d) {
      if (drives[d].joint != static_cast<int>(joint.index)) continue;
      const std::string name =
          count == 1 ? wanted.drive
                     : mechanism::drive_name(context.definition, drives[d]);
      seats.push_back(
          {.joint = joint,
           .drive = d,
           .turns = mechanism::drives_angle(context.definition, drives[d]),
           .seat = {.name = "drive " + name,
                    .group = wanted.group,
                    .kind = SeatKind::kPressure,
                    .p_LS = face.centroid},
           .area = face.area,
           .pressurized = pressurized});
    }
  }
  return seats;
}

bool carries_wheels(const SeatContext& context,
                    const mechanism::CouplingDefinition& coupling) {
  const auto wheels =
      mechanism::meshing_wheels(context.definition.joints, coupling);
  return context.body == wheels->carrier_1 || context.body == wheels->carrier_2;
}

void require_seats(const SeatContext& context) {
  const auto& definition = context.definition;
  const auto on_body = [&](const mechanism::JointDefinition& joint) {
    return joint.body_a == context.body || joint.body_b == context.body;
  };
  for (const auto& coupling : definition.couplings) {
    if (coupling.teeth && carries_wheels(context, coupling)) continue;
    for (const int index : {coupling.joint_1, coupling.joint_2}) {
      const auto& joint = definition.joints[static_cast<std::size_t>(index)];
      if (on_body(joint)) refuse_teeth(context, coupling, joint);
    }
  }
  std::string missing;
  for (const auto& joint : definition.joints) {
    if (on_body(joint) &&
        std::ranges::find(context.part.seats, joint.name, &part::Seat::joint) ==
            context.part.seats.end()) {
      missing += fmt::format("{}joint \"{}\"", missing.empty() ? "" : ", ",
                             joint.name);
    }
  }
  for (const auto& drive : definition.drives) {
    const auto& joint =
        definition.joints[static_cast<std::size_t>(drive.joint)];
    if (on_body(joint) &&
        std::ranges::find(context.part.drive_seats, joint.name,
                          &part::DriveSeat::drive) ==
            context.part.drive_seats.end()) {
      missing += fmt::format("{}drive of \"{}\"", missing.empty() ? "" : ", ",
                             joint.name);
    }
  }
  if (!missing.empty()) {
    throw Error("L004", context.place("seats"),
                "no group of the mesh takes the load of " + missing,
                "Add them: pins = { JOINT = \"group\" }, drives = { JOINT = { "
                "face = \"group\" } }.");
  }
}

void require_tooth_forces(const SeatContext& context,
                          const mechanism::Motion& motion) {
  const auto& definition = context.definition;
  for (std::size_t k = 0; k < definition.couplings.size(); ++k) {
    const auto& coupling = definition.couplings[k];
    for (const std::size_t index :
         mechanism::joints_without_teeth(definition, motion, k)) {
      const auto& joint = definition.joints[index];
      if (joint.body_a != context.body && joint.body_b != context.body) {
        continue;
      }
      throw Error(
          "L004", context.place("seats"),
          fmt::format("the tooth force of coupling \"{}\" is not resolved, and "
                      "the part has its share of it by joint \"{}\"",
                      coupling.name, joint.name),
          coupling.teeth
              ? "Equilibrium has to find the coupling's effort; or check the "
                "part by a [[part.history]] with their forces."
              : "Give the coupling its `pressure_angle`, its joints one body "
                "in common that carries both wheels; or check the part by a "
                "[[part.history]] with the forces on its teeth.");
    }
  }
}

}  // namespace clevis::loads
