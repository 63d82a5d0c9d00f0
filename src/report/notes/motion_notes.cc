#include "report/notes/motion_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mechanism/definition/drive_names.h"
#include "mechanism/force_elements/breakaway.h"
#include "mechanism/structure/tooth_paths.h"
#include "report/notes/definition_notes.h"
#include "report/notes/element_notes.h"
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

/// Whether a rate keeps its sense over a motion and is not on its way to rest.
/// @param rates  by instant [m/s] or [rad/s]. @param least  round-off.
bool is_under_way(const std::vector<Vector3d>& rates, double least) {
  constexpr double kOfFastest = 0.5;
  const Vector3d& end = rates.back();
  double fastest = 0.0;
  for (const Vector3d& rate : rates) fastest = std::max(fastest, rate.norm());
  return fastest > least && end.norm() > kOfFastest * fastest &&
         std::ranges::all_of(rates, [&](const Vector3d& rate) {
           return rate.norm() <= least || rate.dot(end) >= 0.0;
         });
}

/// As of ms that were meant as s, where forces decide: everything that moves
/// is still on its way from where it began.
void add_unmoved(const MechanismDefinition& definition, const Motion& motion,
                 std::vector<std::string>& notes) {
  constexpr double kOfSize = 0.01, kOfTurn = 0.01 * 360.0 * kDegree;
  constexpr double kRoundOff = 1e-9, kMilli = 1e-3;
  const double size = mechanism_size(definition);
  if (!motion.integration || motion.instants.size() < 2 || size == 0.0) return;
  const auto& first = motion.instants.front();
  const double duration = motion.instants.back().t - first.t;
  double way = 0.0, turn = 0.0;
  bool any_moves = false;
  for (std::size_t b = 0; b < definition.bodies.size(); ++b) {
    const part::Pose& start = first.bodies[b].pose;
    std::vector<Vector3d> speeds, spins;
    for (const mechanism::Instant& instant : motion.instants) {
      const mechanism::BodyState& body = instant.bodies[b];
      way = std::max(way, (body.pose.p_WL - start.p_WL).norm());
      turn = std::max(
          turn,
          Eigen::AngleAxisd(body.pose.R_WL * start.R_WL.transpose()).angle());
      speeds.push_back(body.v_WLo);
      spins.push_back(body.w_WL);
    }
    const double slow = kRoundOff * size / duration;
    const double idle = kRoundOff / duration;
    const auto rests = [](const std::vector<Vector3d>& rates, double least) {
      return std::ranges::all_of(rates, [&](const Vector3d& rate) {
        return rate.norm() <= least;
      });
    };
    const bool slides = !rests(speeds, slow), turns = !rests(spins, idle);
    any_moves |= slides || turns;
    if ((slides && !is_under_way(speeds, slow)) ||
        (turns && !is_under_way(spins, idle))) {
      return;
    }
  }
  if (!any_moves || way >= kOfSize * size || turn >= kOfTurn) return;
  notes.push_back(fmt::format(
      "no body moves by more than {:.3g} mm or turns by more than {:.3g} deg "
      "over the motion of {:.4g} s, and what moves is still on its way: see "
      "that the units of the duration and of the forces are right",
      way / kMilli, turn / kDegree, duration));
}

/// As of a drive's duration in ms that was meant in s.
void add_speeds(const MechanismDefinition& definition, const Motion& motion,
                std::vector<std::string>& notes) {
  constexpr double kSound = 340.0;     // in air [m/s]
  constexpr double kHardest = 20.0e3;  // 2000 times gravity [m/s²]
  constexpr double kGravity = 9.81;
  double fastest = 0.0, hardest = 0.0;
  std::size_t fast = 0, hard = 0;
  for (const mechanism::Instant& instant : motion.instants) {
    for (std::size_t b = 0; b < instant.bodies.size(); ++b) {
      const mechanism::BodyState& body = instant.bodies[b];
      const Vector3d arm =
          body.pose.R_WL * definition.bodies[b].mass_properties.p_LCm;
      const double speed = (body.v_WLo + body.w_WL.cross(arm)).norm();
      const double acceleration = (body.a_WLo + body.alpha_WL.cross(arm) +
                                   body.w_WL.cross(body.w_WL.cross(arm)))
                                      .norm();
      if (speed > fastest) {
        fastest = speed;
        fast = b;
      }
      if (acceleration > hardest) {
        hardest = acceleration;
        hard = b;
      }
    }
  }
  if (fastest > kSound) {
    notes.push_back(fmt::format(
        "body {} moves at {:.4g} m/s, faster than sound in air: see that the "
        "units of speeds and times are right",
        definition.bodies[fast].name, fastest));
  } else if (hardest > kHardest && !motion.integration) {
    // Blows, which are integrated, may well be as hard.
    notes.push_back(fmt::format(
        "body {} is accelerated by {:.4g} m/s^2, {:.3g} times gravity: see "
        "that the units of the drives' speeds and times are right",
        definition.bodies[hard].name, hardest, hardest / kGravity));
  }
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
  const double length = mechanism_size(definition);
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

std::string names_of(const MechanismDefinition& definition,
                     const std::vector<int>& bodies) {
  std::vector<std::string> names;
  for (const int body : bodies) {
    names.push_back(definition.bodies[static_cast<std::size_t>(body)].name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

void add_unshared(const MechanismDefinition& definition, const Motion& motion,
                  std::vector<std::string>& notes) {
  const auto& [spun, loaded] = motion.unshared;
  if (!spun.empty()) {
    notes.push_back(fmt::format(
        "{}: joints hold against one another what its spin would stretch, and "
        "rigid links leave that out; links = \"elastic\" counts it",
        names_of(definition, spun)));
  }
  if (!loaded.empty()) {
    notes.push_back(fmt::format(
        "{}: what pressure on its faces strains is left out of how its joints "
        "share reactions; take links = \"rigid\" and give the joints "
        "compliances that stand for the links too",
        names_of(definition, loaded)));
  }
}

void add_teeth(const MechanismDefinition& definition, const Motion& motion,
               std::vector<std::string>& notes) {
  for (std::size_t k = 0; k < definition.couplings.size(); ++k) {
    const auto& coupling = definition.couplings[k];
    std::vector<std::string> names;
    for (const std::size_t joint :
         mechanism::joints_without_teeth(definition, motion, k)) {
      names.push_back(definition.joints[joint].name);
    }
    if (names.empty()) continue;
    notes.push_back(fmt::format(
        "coupling {}: each joint takes its torque or force along its "
        "coordinate alone. What teeth press across it with is not in the "
        "reactions of {}",
        coupling.name, fmt::join(names, ", ")));
  }
}

}  // namespace

std::vector<std::string> motion_notes(const MechanismDefinition& definition,
                                      const Motion& motion) {
  std::vector<std::string> notes;
  add_definition_notes(definition, notes);
  add_short_motions(definition, motion, notes);
  add_unmoved(definition, motion, notes);
  add_speeds(definition, motion, notes);
  add_freedom(definition, motion, notes);
  add_assembly(definition, motion, notes);
  add_search(motion, notes);
  add_breakaway(definition, motion, notes);
  add_unshared(definition, motion, notes);
  add_teeth(definition, motion, notes);
  add_element_notes(definition, motion, notes);
  return notes;
}

}  // namespace clevis::report
