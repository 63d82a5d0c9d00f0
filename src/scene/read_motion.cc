#include <fmt/format.h>

#include "scene/readers.h"

namespace clevis::scene {
namespace {

using mechanism::DriveDefinition;
using mechanism::DriveLaw;
using mechanism::ForceDefinition;
using mechanism::JointDefinition;
using mechanism::JointType;
using mechanism::MarkerDefinition;

/// A name for messages and files of entities that need none.
std::string name_or_number(StrictTable& table, std::string_view kind,
                           std::size_t count, NameIndex& index) {
  const auto name = table.find("name");
  const std::string text =
      name ? name->title() : fmt::format("{}_{}", kind, count + 1);
  index.add(text, name ? *name : table["type"]);
  return text;
}

double read_start(StrictTable& table) {
  const auto start = table.find("start");
  if (!start) return 0.0;
  const double time = start->quantity(Dimension::kTime);
  if (time < 0.0) {
    throw start->refusal("S006", "is negative", "The motion starts at 0 s.");
  }
  return time;
}

DriveDefinition read_drive(StrictTable& table,
                           const std::vector<JointDefinition>& joints,
                           Names& names) {
  DriveDefinition drive;
  drive.place = table.place();
  const Value joint = table["joint"];
  const std::string joint_name = joint.name();
  drive.joint = names.joints.find(joint_name, joint);
  names.drives.add(joint_name, joint);
  const JointType type = joints[static_cast<std::size_t>(drive.joint)].type;
  if (type == JointType::kWeld) {
    throw joint.refusal("S010", "= \"" + joint_name + "\" is a weld",
                        "Drive a revolute or a prismatic joint.");
  }
  const Dimension coordinate =
      type == JointType::kRevolute ? Dimension::kAngle : Dimension::kLength;
  const Value law = table["law"];
  drive.law = law.choice<DriveLaw>({{"constant", DriveLaw::kConstant},
                                    {"ramp", DriveLaw::kRamp},
                                    {"quintic", DriveLaw::kQuintic},
                                    {"sine", DriveLaw::kSine}});
  drive.from = table["from"].quantity(coordinate);
  drive.to = drive.from;
  if (drive.law == DriveLaw::kRamp || drive.law == DriveLaw::kQuintic) {
    drive.to = table["to"].quantity(coordinate);
    drive.start = read_start(table);
    drive.duration = table["duration"].positive(Dimension::kTime);
  } else if (drive.law == DriveLaw::kSine) {
    drive.start = read_start(table);
    drive.amplitude = table["amplitude"].quantity(coordinate);
    drive.frequency = table["frequency"].positive(Dimension::kFrequency);
  }
  table.finish(fmt::format("with law = \"{}\"", law.text()));
  return drive;
}

ForceDefinition read_force(StrictTable& table, std::size_t count,
                           Names& names) {
  ForceDefinition force;
  force.place = table.place();
  enum class Type { kConstant };
  table["type"].choice<Type>({{"constant", Type::kConstant}});
  force.name = name_or_number(table, "force", count, names.forces);
  const Value body = table["body"];
  force.body = names.bodies.find(body.name(), body);
  force.p_LP = table["point"].vector(Dimension::kLength);
  force.f_W = table["force"].vector(Dimension::kForce);
  if (const auto moment = table.find("moment")) {
    force.t_W = moment->vector(Dimension::kTorque);
  }
  return force;
}

MarkerDefinition read_marker(StrictTable& table, Names& names) {
  MarkerDefinition marker;
  const Value name = table["name"];
  marker.name = name.name();
  names.markers.add(marker.name, name);
  const Value body = table["body"];
  marker.body = names.bodies.find(body.name(), body);
  marker.p_LP = table["point"].vector(Dimension::kLength);
  return marker;
}

}  // namespace

std::vector<DriveDefinition> read_drives(
    StrictTable& root, const std::vector<JointDefinition>& joints,
    Names& names) {
  std::vector<DriveDefinition> drives;
  for (StrictTable& table : root.tables("drive")) {
    drives.push_back(read_drive(table, joints, names));
  }
  return drives;
}

std::vector<ForceDefinition> read_forces(StrictTable& root, Names& names) {
  std::vector<ForceDefinition> forces;
  for (StrictTable& table : root.tables("force")) {
    forces.push_back(read_force(table, forces.size(), names));
  }
  return forces;
}

std::vector<MarkerDefinition> read_markers(StrictTable& root, Names& names) {
  std::vector<MarkerDefinition> markers;
  for (StrictTable& table : root.tables("marker")) {
    markers.push_back(read_marker(table, names));
  }
  return markers;
}

mechanism::SimulationSettings read_simulation(StrictTable table) {
  constexpr int kMostInstants = 100'000;
  mechanism::SimulationSettings settings;
  settings.duration = table["duration"].positive(Dimension::kTime);
  if (const auto instants = table.find("instants")) {
    settings.instants = instants->integer(2, kMostInstants);
  }
  if (const auto tolerance = table.find("tolerance")) {
    settings.tolerance = tolerance->number(1e-14, 1e-3);
  }
  return settings;
}

}  // namespace clevis::scene
