#include "scene/motion/read_drives.h"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mechanism/joints/joint_types.h"
#include "scene/motion/read_joint_properties.h"
#include "scene/text/names.h"
#include "scene/text/times.h"

namespace clevis::scene {
namespace {

using mechanism::DriveDefinition;
using mechanism::DriveLaw;
using mechanism::JointDefinition;
using numerics::SplineEnds;

double read_start(StrictTable& table) {
  const auto start = table.find("start");
  if (!start) return 0.0;
  const double time = start->quantity(Dimension::kTime);
  if (time < 0.0) {
    throw start->refusal("S006", "is negative", "The motion starts at 0 s.");
  }
  return time;
}

Dimension rate_of(Dimension coordinate) {
  return coordinate == Dimension::kAngle ? Dimension::kAngularVelocity
                                         : Dimension::kVelocity;
}

/// @return the drive's joint and coordinate set, its dimension second.
Dimension read_driven(StrictTable& table,
                      const std::vector<JointDefinition>& joints, Names& names,
                      DriveDefinition& drive) {
  const Value joint = table["joint"];
  const std::string joint_name = joint.name();
  drive.joint = names.joints.find(joint_name, joint);
  const JointDefinition& driven = joints[static_cast<std::size_t>(drive.joint)];
  const auto all = mechanism::coordinates(driven.type);
  if (all.empty()) {
    throw joint.refusal(
        "S010",
        fmt::format("= \"{}\" is a {}", joint_name, name_of(driven.type)),
        "Drive a joint that has a coordinate, such as a revolute or a "
        "prismatic joint.");
  }
  const auto coordinate = table.find("coordinate");
  if (coordinate) drive.coordinate = find_coordinate(*coordinate, driven);
  const auto k = static_cast<std::size_t>(drive.coordinate);
  names.drives.add(
      k == 0 ? joint_name : fmt::format("{}.{}", joint_name, all[k].name),
      coordinate ? *coordinate : joint);
  return all[k].row.is_angle() ? Dimension::kAngle : Dimension::kLength;
}

/// A coordinate that some machine reaches. @throws Error S011.
double reachable(const Value& value, Dimension coordinate) {
  constexpr double kFarthest = 1e6;     // m
  constexpr double kMostTurned = 1e10;  // rad
  const double q = value.quantity(coordinate);
  const bool is_angle = coordinate == Dimension::kAngle;
  if (std::abs(q) <= (is_angle ? kMostTurned : kFarthest)) return q;
  throw value.refusal(
      "S011",
      fmt::format("is {:.3g} {}, farther than any machine moves", q,
                  is_angle ? "rad" : "m"),
      "Check the number and its unit.");
}

numerics::CubicSpline read_table(StrictTable& table, Dimension coordinate) {
  const Value times = table["times"], positions = table["positions"];
  std::vector<double> t = increasing_times(times, 2), q;
  for (const Value& value : positions.elements()) {
    q.push_back(reachable(value, coordinate));
  }
  if (t.size() != q.size()) {
    throw positions.refusal(
        "S010", fmt::format("has {} entries for {} times", q.size(), t.size()),
        "Give one position for each time.");
  }
  const numerics::SplineEnds ends = read_spline_ends(table);
  return numerics::interpolating_spline(std::move(t), std::move(q), ends);
}

}  // namespace

void read_drive_law(StrictTable& table, Dimension coordinate,
                    DriveDefinition& drive) {
  const Value law = table["law"];
  drive.law = law.choice<DriveLaw>({{"constant", DriveLaw::kConstant},
                                    {"ramp", DriveLaw::kRamp},
                                    {"quintic", DriveLaw::kQuintic},
                                    {"sine", DriveLaw::kSine},
                                    {"table", DriveLaw::kTable},
                                    {"speed", DriveLaw::kSpeed}});
  if (drive.law == DriveLaw::kTable) {
    drive.start = read_start(table);
    drive.table = read_table(table, coordinate);
    drive.from = drive.table.values.front();
    drive.to = drive.table.values.back();
  } else {
    drive.from = reachable(table["from"], coordinate);
    drive.to = drive.from;
  }
  if (drive.law == DriveLaw::kRamp || drive.law == DriveLaw::kQuintic) {
    drive.to = reachable(table["to"], coordinate);
    drive.start = read_start(table);
    drive.duration = table["duration"].positive(Dimension::kTime);
  } else if (drive.law == DriveLaw::kSine) {
    drive.start = read_start(table);
    drive.amplitude = reachable(table["amplitude"], coordinate);
    drive.frequency = table["frequency"].positive(Dimension::kFrequency);
  } else if (drive.law == DriveLaw::kSpeed) {
    drive.start = read_start(table);
    drive.speed = table["speed"].quantity(rate_of(coordinate));
  }
}

namespace {

DriveDefinition read_drive(StrictTable& table,
                           const std::vector<JointDefinition>& joints,
                           Names& names) {
  DriveDefinition drive;
  drive.place = table.place();
  const Dimension coordinate = read_driven(table, joints, names, drive);
  read_drive_law(table, coordinate, drive);
  table.finish(fmt::format("with law = \"{}\"", table["law"].text()));
  return drive;
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

}  // namespace clevis::scene
