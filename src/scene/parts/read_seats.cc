#include "scene/parts/read_seats.h"

#include <algorithm>

#include <fmt/format.h>

#include "mechanism/joints/joint_types.h"
#include "scene/parts/read_force_seats.h"
#include "scene/solids/joint_faces.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using mechanism::BodyIndex;
using mechanism::MechanismDefinition;
using part::PartDefinition;

/// The body that moves with the part, kGround if there is none.
BodyIndex body_of(const PartDefinition& part,
                  const MechanismDefinition& mechanism) {
  BodyIndex found = mechanism::kGround;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const auto& body = mechanism.bodies[i];
    if (body.part != part.name) continue;
    if (found != mechanism::kGround) {
      throw Error("S010", body.place,
                  fmt::format("two bodies have the part \"{}\"", part.name),
                  "Define a part for each: their pins belong to different "
                  "joints.");
    }
    found = static_cast<BodyIndex>(i);
  }
  return found;
}

bool touches(const mechanism::JointDefinition& joint, BodyIndex body) {
  return joint.body_a == body || joint.body_b == body;
}

/// The joint that a key of pins or drives names. @throws Error S010 if it
/// does not touch the part's body.
int find_joint(const std::string& name, const Value& value, BodyIndex body,
               const MechanismDefinition& mechanism, const NameIndex& joints) {
  const int joint = joints.find(name, value);
  if (!touches(mechanism.joints[static_cast<std::size_t>(joint)], body)) {
    throw value.refusal(
        "S010",
        fmt::format("is a joint of other bodies than \"{}\"",
                    mechanism.bodies[static_cast<std::size_t>(body)].name),
        "Give the joints of the body that has this part.");
  }
  return joint;
}

part::SlideContact read_slide_contact(StrictTable& pin) {
  part::SlideContact contact;
  if (const auto length = pin.find("length")) {
    contact.length = length->positive(Dimension::kLength);
    if (const auto offset = pin.find("offset")) {
      contact.offset = offset->quantity(Dimension::kLength);
    }
  }
  if (const auto width = pin.find("width")) {
    contact.width = width->positive(Dimension::kLength);
  }
  pin.finish("without `length`");
  return contact;
}

/// Groups that pins name, or that joints of a solid find.
struct PinGroups {
  BodyIndex body;
  part::SolidSource* solid;  ///< none: a mesh has its groups

  std::string read(const mechanism::JointDefinition& joint,
                   const Value& value) const {
    const std::string text = value.text();
    if (solid == nullptr || text != kAutoFaces) return text;
    return find_by_joint(joint, body, value.place(), *solid);
  }
};

/// A group, or a table with it and what a slide touches of it.
part::Seat read_pin(const mechanism::JointDefinition& joint, const Value& value,
                    const PinGroups& groups_of) {
  if (!value.is_table()) return {joint.name, groups_of.read(joint, value)};
  StrictTable pin(value, "part.pins");
  if (!mechanism::traits(joint.type).slides()) {
    const part::Seat seat{joint.name, groups_of.read(joint, pin["group"])};
    pin.finish(
        fmt::format("on joint \"{}\", which does not slide", joint.name));
    return seat;
  }
  const std::vector<Value> groups =
      pin.has("groups") ? pin["groups"].elements() : std::vector{pin["group"]};
  if (groups.empty() || groups.size() > 2) {
    throw pin["groups"].refusal("S006", "is no pair of walls",
                                "Give one group, or two that face each other.");
  }
  part::Seat seat{joint.name, groups_of.read(joint, groups.front())};
  seat.slide = read_slide_contact(pin);
  if (groups.size() == 2) seat.slide.opposite = groups.back().text();
  return seat;
}

/// Joints need groups of a mesh to load; a part that forces alone hold has
/// none.
void require_no_joint(const MechanismDefinition& mechanism, BodyIndex body,
                      const StrictTable& table) {
  std::string pins;
  for (const auto& joint : mechanism.joints) {
    if (!touches(joint, body)) continue;
    pins += fmt::format("{}{} = \"...\"", pins.empty() ? "" : ", ", joint.name);
  }
  if (pins.empty()) return;
  throw table.refusal(
      "S003", "lacks the key \"pins\"",
      fmt::format("Add pins = {{ {} }}, of each joint the group of the mesh "
                  "where it loads the part.",
                  pins));
}

void read_pins(StrictTable& table, BodyIndex body,
               const MechanismDefinition& mechanism, const Names& names,
               PartDefinition& part, part::SolidSource& solid) {
  const bool is_solid = part::is_solid_file(part.geometry);
  if (!table.has("pins")) {
    if (!is_solid) require_no_joint(mechanism, body, table);
    for (const auto& joint : mechanism.joints) {
      if (!touches(joint, body)) continue;
      part.seats.push_back(
          {joint.name, find_by_joint(joint, body, table.place(), solid)});
    }
    return;
  }
  const Value pins = table["pins"];
  const PinGroups groups{body, is_solid ? &solid : nullptr};
  for (const auto& [name, value] : pins.entries()) {
    const int joint = find_joint(name, value, body, mechanism, names.joints);
    part.seats.push_back(read_pin(
        mechanism.joints[static_cast<std::size_t>(joint)], value, groups));
  }
  for (const auto& joint : mechanism.joints) {
    const auto is_seat = [&](const part::Seat& seat) {
      return seat.joint == joint.name;
    };
    if (!touches(joint, body) || std::ranges::any_of(part.seats, is_seat)) {
      continue;
    }
    throw pins.refusal(
        "S003", fmt::format("lacks the joint \"{}\"", joint.name),
        "Name the group of the mesh where this joint loads the part.");
  }
}

void read_drive_seats(StrictTable& table, BodyIndex body,
                      const MechanismDefinition& mechanism, const Names& names,
                      PartDefinition& part) {
  const auto drives = table.find("drives");
  if (drives) {
    for (const auto& [joint, value] : drives->entries()) {
      names.drives.find(joint, value);
      find_joint(joint, value, body, mechanism, names.joints);
      StrictTable entry(value, "part.drives");
      part::DriveSeat seat{joint, entry["face"].text(), {}};
      if (const auto pressurized = entry.find("pressurized")) {
        for (const Value& group : pressurized->elements()) {
          seat.pressurized.push_back(group.text());
        }
      }
      part.drive_seats.push_back(seat);
    }
  }
  for (const auto& drive : mechanism.drives) {
    const auto& joint = mechanism.joints[static_cast<std::size_t>(drive.joint)];
    const auto is_seat = [&](const part::DriveSeat& seat) {
      return seat.drive == joint.name;
    };
    if (!touches(joint, body) ||
        std::ranges::any_of(part.drive_seats, is_seat)) {
      continue;
    }
    throw table.refusal(
        "S003", fmt::format("\"{}\" lacks drives.{}", part.name, joint.name),
        "Say which face of the part takes the effort of this drive: drives = "
        "{ JOINT = { face = \"GROUP\" } }.");
  }
}

}  // namespace

void read_seats(StrictTable& table, const MechanismDefinition& mechanism,
                const Names& names, PartDefinition& part,
                part::SolidSource& solid) {
  const BodyIndex body = body_of(part, mechanism);
  if (body != mechanism::kGround) {
    read_pins(table, body, mechanism, names, part, solid);
    read_drive_seats(table, body, mechanism, names, part);
    read_force_seats(table, body, mechanism, names, part);
  } else if (part.cases.empty() && part.series.empty() &&
             part.impacts.empty()) {
    throw table.refusal(
        "S003",
        fmt::format("\"{}\" has no load: no body has it and "
                    "it has no [[part.case]], [[part.history]] or [[impact]]",
                    part.name),
        "Give a body part = \"" + part.name + "\", or give the part a case.");
  }
  if (body != mechanism::kGround && !part.impacts.empty()) {
    throw Error(
        "S010", part.impacts.front().place,
        fmt::format("[[impact]] on \"{}\", which is a body's part", part.name),
        "Only parts that rest on `fixed` supports can be struck; give "
        "the blow to a part that no body has.");
  }
  table.finish("without a body that has this part");
}

}  // namespace clevis::scene
