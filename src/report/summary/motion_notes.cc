#include "report/summary/motion_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mechanism/definition/drive_names.h"
#include "mechanism/force_elements/breakaway.h"
#include "report/text/terminal.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using Eigen::Vector3d;
using mechanism::BodyDefinition;
using mechanism::MechanismDefinition;
using mechanism::Motion;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Where a motion that forces decide begins.
std::string start_of(const MechanismDefinition& definition) {
  const bool moves =
      std::ranges::any_of(definition.initial_joints,
                          [](const auto& initial) {
                            return initial.rate.value_or(0.0) != 0.0;
                          }) ||
      std::ranges::any_of(definition.initial_bodies, [](const auto& initial) {
        return !initial.v_WLo.isZero(0.0) || !initial.w_WL.isZero(0.0);
      });
  const bool placed =
      std::ranges::any_of(definition.initial_joints, [](const auto& initial) {
        return initial.position.has_value();
      });
  return fmt::format("from {}, in the position of {}",
                     moves ? "the rates of [[initial]]" : "rest",
                     placed ? "[[initial]]" : "the placements");
}

/// Whether anything but weight and passive forces moves what is free.
bool is_pushed(const MechanismDefinition& definition) {
  return !definition.initial_joints.empty() ||
         !definition.initial_bodies.empty() ||
         std::ranges::any_of(definition.elements, [](const auto& element) {
           return properties(element).actuation ==
                  mechanism::Actuation::kMachine;
         });
}

void add_freedom(const MechanismDefinition& definition, const Motion& motion,
                 std::vector<std::string>& notes) {
  if (!motion.left_free) return;
  const mechanism::LeftFree& free = *motion.left_free;
  if (free.freedom == 0) {
    notes.push_back(
        "the motion is integrated: gas, motors or bristles have a history of "
        "their own");
    return;
  }
  notes.push_back(fmt::format(
      "no drive fixes {} degree{} of freedom{}: forces decide, the motion is "
      "integrated {}. {}",
      free.freedom, free.freedom == 1 ? "" : "s",
      free.coordinates.empty()
          ? ""
          : fmt::format(" ({})", fmt::join(free.coordinates, ", ")),
      start_of(definition),
      is_pushed(definition)
          ? "Say motion = \"dynamic\" if that is meant"
          : "If a drive was forgotten, add it; else say motion = \"dynamic\""));
}

/// The moon has 1.6 m/s², Jupiter 25; 9810 were meant as mm/s².
void add_gravity(const MechanismDefinition& definition,
                 std::vector<std::string>& notes) {
  constexpr double kEarth = 9.81, kLeast = 1.0, kLargest = 30.0;  // [m/s²]
  const double gravity = definition.gravity_W.norm();
  if (gravity == 0.0 || (kLeast <= gravity && gravity <= kLargest)) return;
  notes.push_back(fmt::format(
      "gravity is {:.4g} m/s^2, {:.4g} times the earth's: see that its unit is "
      "right",
      gravity, gravity / kEarth));
}

/// Of the ellipsoid that has a body's mass and inertia [kg/m³]. Of all bodies
/// of one density the ellipsoid has the least inertia: no body is less dense.
/// @param least  semi-axis, over the largest: inertias of laminae and of rods
///               are given without it [1].
double density_of_ellipsoid(const part::MassProperties& given, double least) {
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                               given.inertia_LCm, Eigen::EigenvaluesOnly)
                               .eigenvalues();
  const Vector3d squares =
      (5.0 / given.mass *
       (Vector3d::Constant(0.5 * moments.sum()) - moments).array())
          .max(0.0);
  const Vector3d axes = squares.cwiseSqrt();
  return given.mass / (4.0 / 3.0 * std::numbers::pi *
                       axes.cwiseMax(least * axes.maxCoeff()).prod());
}

/// Bodies that are given as all but points are spared.
void add_densities(const MechanismDefinition& definition,
                   std::vector<std::string>& notes) {
  constexpr double kLargest = 10.0 * 25000.0;  // [kg/m³], of materials: 25000
  constexpr double kLeast = 10.0;  // frames of thin tubes have more [kg/m³]
  constexpr double kThick = 1.0 / 20.0, kThin = 1.0 / 50.0;
  for (const BodyDefinition& body : definition.bodies) {
    const part::MassProperties& given = body.mass_properties;
    if (!body.part.empty() || !(given.mass > 0.0) ||
        !(given.inertia_LCm.trace() > 0.0)) {
      continue;
    }
    const double most = density_of_ellipsoid(given, kThin);
    const double least = density_of_ellipsoid(given, kThick);
    if (least > kLargest) {
      notes.push_back(fmt::format(
          "body {} of {:.4g} kg has so little inertia that it would have "
          "{:.2g} kg/m^3 at least: see that the units of its mass and inertia "
          "are right",
          body.name, given.mass, least));
    } else if (most < kLeast) {
      notes.push_back(fmt::format(
          "body {} of {:.4g} kg has so much inertia that it would have {:.2g} "
          "kg/m^3 as a solid: see that the units of its mass and inertia are "
          "right",
          body.name, given.mass, most));
    }
  }
}

/// Places of a body's joints on it [m].
std::vector<Vector3d> joints_on(const MechanismDefinition& definition,
                                std::size_t body) {
  std::vector<Vector3d> places;
  for (const auto& joint : definition.joints) {
    for (const auto& [on, frame] : {std::pair(joint.body_a, joint.frame_a),
                                    std::pair(joint.body_b, joint.frame_b)}) {
      if (on == static_cast<int>(body)) places.push_back(frame.p_LJ);
    }
  }
  return places;
}

/// As of m that were meant as mm. Meshes tell the centres of parts.
void add_far_centres(const MechanismDefinition& definition,
                     std::vector<std::string>& notes) {
  constexpr double kFar = 3.0, kMilli = 1e-3;
  for (std::size_t b = 0; b < definition.bodies.size(); ++b) {
    const BodyDefinition& body = definition.bodies[b];
    if (!body.part.empty()) continue;
    double span = 0.0, distance = HUGE_VAL;
    const std::vector<Vector3d> places = joints_on(definition, b);
    for (const Vector3d& place : places) {
      distance =
          std::min(distance, (place - body.mass_properties.p_LCm).norm());
      for (const Vector3d& other : places) {
        span = std::max(span, (place - other).norm());
      }
    }
    if (span == 0.0 || distance <= kFar * span) continue;
    notes.push_back(fmt::format(
        "the centre of mass of body {} is {:.4g} mm from its nearest joint, "
        "{:.3g} times as far as its joints are apart ({:.4g} mm): see that its "
        "unit is right",
        body.name, distance / kMilli, distance / span, span / kMilli));
  }
}

/// Amount by which a drive's law sets out to move, however short the motion
/// [rad] or [m].
double meant_travel(const mechanism::DriveDefinition& drive) {
  switch (drive.law) {
    case mechanism::DriveLaw::kSpeed:
      return drive.speed != 0.0 ? HUGE_VAL : 0.0;
    case mechanism::DriveLaw::kRamp:
    case mechanism::DriveLaw::kQuintic:
      return std::abs(drive.to - drive.from);
    case mechanism::DriveLaw::kSine:
      return std::abs(drive.amplitude);
    case mechanism::DriveLaw::kTable: {
      if (drive.table.values.empty()) return 0.0;
      const auto [least, most] = std::ranges::minmax(drive.table.values);
      return most - least;
    }
    case mechanism::DriveLaw::kConstant:
      break;
  }
  return 0.0;
}

/// What a drive does that hardly moves, as far as a scale is known for it.
/// @param moved  over the motion [rad] or [m]. @param duration  of it [s].
std::optional<std::string> little_travel(
    const MechanismDefinition& definition,
    const mechanism::DriveDefinition& drive, double moved, double duration) {
  constexpr double kOfTurn = 0.01 * 360.0 * kDegree, kOfLaw = 0.01;
  constexpr double kMilli = 1e-3;
  const double meant = meant_travel(drive);
  if (mechanism::drives_angle(definition, drive)) {
    if (moved >= kOfTurn || meant < kOfTurn) return std::nullopt;
    return fmt::format(
        "turns by {:.3g} deg over the whole motion of {:.4g} s, less than a "
        "hundredth of a turn",
        moved / kDegree, duration);
  }
  if (!std::isfinite(meant) || moved >= kOfLaw * meant) return std::nullopt;
  return fmt::format(
      "moves by {:.3g} mm over the whole motion of {:.4g} s, less than a "
      "hundredth of the {:.4g} mm of its law",
      moved / kMilli, duration, meant / kMilli);
}

/// As of ms that were meant as s.
void add_short_motions(const MechanismDefinition& definition,
                       const Motion& motion, std::vector<std::string>& notes) {
  if (motion.instants.size() < 2) return;
  const double duration = motion.instants.back().t - motion.instants.front().t;
  for (std::size_t d = 0; d < definition.drives.size(); ++d) {
    const auto& drive = definition.drives[d];
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const mechanism::Instant& instant : motion.instants) {
      least = std::min(least, instant.drives[d].position);
      most = std::max(most, instant.drives[d].position);
    }
    const auto little =
        little_travel(definition, drive, most - least, duration);
    if (!little) continue;
    notes.push_back(fmt::format(
        "the drive of {} {}: see that the units of its law and of the duration "
        "are right",
        mechanism::drive_name(definition, drive), *little));
  }
}

/// Bodies that no joint holds, where others are held.
void add_unjoined(const MechanismDefinition& definition,
                  std::vector<std::string>& notes) {
  if (definition.joints.empty()) return;
  for (std::size_t b = 0; b < definition.bodies.size(); ++b) {
    const bool is_joined =
        std::ranges::any_of(definition.joints, [&](const auto& joint) {
          return joint.body_a == static_cast<int>(b) ||
                 joint.body_b == static_cast<int>(b);
        });
    if (is_joined) continue;
    notes.push_back(
        fmt::format("body {} has no joint, forces alone move it: join it, or "
                    "leave it out if that is not meant",
                    definition.bodies[b].name));
  }
}

/// Lengths of the mechanism's order, by its joints [m].
double extent(const MechanismDefinition& definition) {
  double length = 0.0;
  for (const auto& joint : definition.joints) {
    for (const auto& [body, frame] : {std::pair(joint.body_a, joint.frame_a),
                                      std::pair(joint.body_b, joint.frame_b)}) {
      if (body != mechanism::kGround) {
        length = std::max(length, frame.p_LJ.norm());
      }
    }
  }
  return length;
}

/// Thousandths, without trailing zeros; no -0.
std::string rounded(double value) {
  return fmt::format("{:.6g}", std::round(1e3 * value) / 1e3 + 0.0);
}

/// Assembly closes the loops near the placements: where these are missing or
/// far, it may be another branch than was meant.
void add_assembly(const MechanismDefinition& definition, const Motion& motion,
                  std::vector<std::string>& notes) {
  constexpr double kFarTurn = 30.0 * kDegree, kFarWay = 0.3;
  constexpr double kRoundOff = 1e-9;  // [m]
  constexpr std::size_t kShown = 3;
  if (motion.instants.empty()) return;
  const double length = extent(definition);
  std::vector<std::string> moved;
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    const BodyDefinition& body = definition.bodies[i];
    const mechanism::Pose& pose = motion.instants.front().bodies[i].pose;
    const Vector3d way = pose.p_WL - body.placement.p_WL;
    const double turn =
        Eigen::AngleAxisd(pose.R_WL * body.placement.R_WL.transpose()).angle();
    if (turn <= kFarTurn &&
        way.norm() <= std::max(kRoundOff, kFarWay * length)) {
      continue;
    }
    const Vector3d mm = millimetres(pose.p_WL);
    moved.push_back(fmt::format(
        "{} to ({}, {}, {}) mm, turned by {:.3g} deg{}", body.name,
        rounded(mm.x()), rounded(mm.y()), rounded(mm.z()), turn / kDegree,
        body.is_placed ? "" : " (it has no placement)"));
  }
  if (moved.empty()) return;
  const std::size_t more = moved.size() - std::min(kShown, moved.size());
  moved.resize(moved.size() - more);
  notes.push_back(fmt::format(
      "to close the joints at the start bodies were moved far from their "
      "placements: {}{}. Loops may close in another position too: give "
      "placements near the one that is meant",
      fmt::join(moved, "; "),
      more > 0 ? fmt::format("; and {} more", more) : ""));
}

void add_search(const Motion& motion, std::vector<std::string>& notes) {
  if (!motion.search || !motion.search->ended) return;
  notes.push_back(fmt::format(
      "the largest loads were looked for in {} positions, which was too few: "
      "from about t = {:.6g} s on larger ones may lie between the instants. "
      "Ask for a shorter motion, or correct the quickest drive",
      motion.search->looks, motion.search->ended_at));
}

/// Whether an element's line rests at an instant, or turns back, and moves.
bool sets_out(const Motion& motion, std::size_t element) {
  constexpr double kRest = 1e-9;  // of the largest rate: round-off
  double forth = 0.0, back = 0.0, least = HUGE_VAL;
  for (const mechanism::Instant& instant : motion.instants) {
    const double rate = instant.elements[element].rate;
    forth = std::max(forth, rate);
    back = std::max(back, -rate);
    least = std::min(least, std::abs(rate));
  }
  const double most = std::max(forth, back);
  return most > 0.0 && (least <= kRest * most || std::min(forth, back) > 0.0);
}

/// Where drives fix the motion friction slides as soon as its line moves.
void add_breakaway(const MechanismDefinition& definition, const Motion& motion,
                   std::vector<std::string>& notes) {
  if (motion.left_free) return;
  for (std::size_t k = 0; k < definition.elements.size(); ++k) {
    const auto& element = definition.elements[k];
    const double over = sudden_breakaway(element);
    if (!(over > 1.0) || !sets_out(motion, k)) continue;
    notes.push_back(fmt::format(
        "friction {}: breaking away from rest takes {}; drives set it in "
        "motion, and that is not in the loads. Give it a `stribeck_speed`, "
        "below which it counts",
        name_of(element),
        std::isfinite(over)
            ? fmt::format("{:.4g} times the effort with which it slides", over)
            : "an effort, sliding none"));
  }
}

}  // namespace

std::vector<std::string> motion_notes(const MechanismDefinition& definition,
                                      const Motion& motion) {
  std::vector<std::string> notes;
  add_gravity(definition, notes);
  add_densities(definition, notes);
  add_far_centres(definition, notes);
  add_short_motions(definition, motion, notes);
  add_freedom(definition, motion, notes);
  add_unjoined(definition, notes);
  add_assembly(definition, motion, notes);
  add_search(motion, notes);
  add_breakaway(definition, motion, notes);
  return notes;
}

std::string note_lines(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) {
    text += printable(fmt::format("  note: {}", note)) + "\n";
  }
  return text;
}

}  // namespace clevis::report
