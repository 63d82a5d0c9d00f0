#include "mechanism/driven_motion/driven_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/reactions/body_motion.h"
#include "mechanism/reactions/power_balance.h"
#include "mechanism/reactions/reaction_friction.h"
#include "mechanism/sampling/instant_brackets.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

void DrivenMotion::refuse_change_point(const ClosedConfiguration& at,
                                       double t) const {
  throw Error(
      "K005", "mechanism",
      fmt::format("at t = {:.6g} s ({}) the constraint Jacobian loses "
                  "rank: {} of {}",
                  t, drives_at(definition_, at.targets, 6),
                  std::min(at.factor.rank(), system_.columns() - 1),
                  system_.columns()),
      "Choose instants, lengths or a range of the drive that avoid "
      "this position, where the branch is undetermined and rigid "
      "reactions have no bound, or let at_singularity be \"continue\".");
}

/// The drives' coordinates at which the branch ends, by the square of the
/// smallest singular value, which falls linearly to zero there.
/// @return how far beyond the last regular position, over the way to it.
double DrivenMotion::dead_end(const Continuation::Reached& reached,
                              VectorXd& targets) const {
  constexpr double kBack = 1e-6;
  if (!reached.at.factor.full_column_rank()) return 0.0;
  const VectorXd back = -kBack * (targets - reached.at.targets);
  const Continuation::Reached behind =
      continuation_.follow(reached.at, reached.at.targets + back);
  targets = reached.at.targets;
  if (behind.part < 1.0 || !behind.at.factor.full_column_rank()) return 0.0;
  const double here = std::pow(reached.at.factor.weakest().sigma, 2);
  const double there = std::pow(behind.at.factor.weakest().sigma, 2);
  const double beyond = here / (there - here);
  if (!(beyond > 0.0 && beyond < 1.0)) return 0.0;
  targets -= beyond * back;
  return beyond;
}

void DrivenMotion::stop(const Moment& from, Continuation::Reached reached,
                        double t) const {
  VectorXd end = drive_positions(definition_, t);
  dead_end(reached, end);
  // when the drive that moves most is there
  const VectorXd way = end - from.at.targets;
  Eigen::Index k = 0;
  way.cwiseAbs().maxCoeff(&k);
  double before = from.t, after = t;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (before + after);
    const double moved =
        drive_positions(definition_, middle)[k] - from.at.targets[k];
    (moved / way[k] < 1.0 ? before : after) = middle;
  }
  throw Error(
      "K004", "mechanism",
      fmt::format("at t = {:.9g} s the mechanism stops at {}: beyond it "
                  "no position continues the motion",
                  before, drives_at(definition_, end, 11)),
      "Reduce the range of the drive, or correct the lengths.");
}

DrivenMotion::Rates DrivenMotion::rates(const ClosedConfiguration& at,
                                        double t) const {
  VectorXd rate = VectorXd::Zero(system_.rows());
  VectorXd second = VectorXd::Zero(system_.rows());
  for (std::size_t k = 0; k < definition_.drives.size(); ++k) {
    const auto row = static_cast<std::size_t>(system_.joint_rows()) + k;
    const double scale = system_.scale(system_.row_list()[row]);
    const DriveTarget target = drive_target(definition_.drives[k], t);
    rate[static_cast<Eigen::Index>(row)] = scale * target.rate;
    second[static_cast<Eigen::Index>(row)] = scale * target.acceleration;
  }
  Rates result;
  result.twists = system_.twists(at.factor.solve(rate));
  second -= system_.bias(at.placed, result.twists);
  result.accelerations = system_.twists(at.factor.solve(second));
  return result;
}

Instant DrivenMotion::kinematics(const ClosedConfiguration& at, double t,
                                 const Rates& rates) const {
  Instant result;
  result.t = t;
  for (const DriveDefinition& drive : definition_.drives) {
    const DriveTarget target = drive_target(drive, t);
    result.drives.push_back({.position = target.position,
                             .rate = target.rate,
                             .acceleration = target.acceleration});
  }
  result.bodies.reserve(definition_.bodies.size());
  for (std::size_t i = 0; i < definition_.bodies.size(); ++i) {
    result.bodies.push_back(body_motion(frame_, static_cast<BodyIndex>(i),
                                        at.x[i + 1], rates.twists[i + 1],
                                        rates.accelerations[i + 1]));
  }
  result.closure_error = at.gap;
  return result;
}

std::vector<Twist> DrivenMotion::elements(const ClosedConfiguration& at,
                                          const Rates& rates,
                                          Instant& result) const {
  forces_.evaluate(result.t, at.x, rates.twists, nullptr);
  forces_.choose_modes();
  forces_.evaluate(result.t, at.x, rates.twists, nullptr);
  forces_.accept(result.t);
  std::vector<Twist> applied(at.x.size());
  forces_.add_to(applied);
  result.elements = forces_.states();
  return applied;
}

Instant DrivenMotion::instant(const ClosedConfiguration& at, double t) const {
  const Rates motion = rates(at, t);
  Instant result = kinematics(at, t, motion);
  elements(at, motion, result);
  const auto balance = [&](std::span<const Twist> applied) {
    return equilibrium_.solve(at.x, at.placed, at.factor, motion.twists,
                              motion.accelerations, applied);
  };
  put_forces(frame_, system_, at.placed,
             balance_with_friction(forces_, at.x.size(), balance), result);
  result.elements = forces_.states();
  require_unique_loads(definition_, forces_, result.joints);
  return result;
}

ClosedConfiguration DrivenMotion::follow(const Moment& from, double t) const {
  Continuation::Reached reached =
      continuation_.follow(from.at, drive_positions(definition_, t));
  if (reached.part < 1.0) stop(from, std::move(reached), t);
  return std::move(reached.at);
}

/// From a regular moment to t, in steps of the drives' travel.
/// @param singular  a time after `last` at which J has no full rank.
void DrivenMotion::advance(Moment& last, std::optional<double>& singular,
                           double t, AtSingularity policy,
                           Motion& motion) const {
  for (const double at : path_.steps(last.t, t)) {
    Moment next(follow(last, at), at);
    if (!next.at.factor.full_column_rank()) {
      if (!singular) singular = at;
      continue;
    }
    if (singular) {
      settle(last, *singular, &next, policy, motion);
      singular.reset();
    } else {
      note_change_points(last, next, policy, motion);
    }
    last = std::move(next);
    if (forces_.counts_turns()) sense(last);
  }
}

void DrivenMotion::sense(const Moment& moment) const {
  forces_.evaluate(moment.t, moment.at.x, rates(moment.at, moment.t).twists,
                   nullptr);
  forces_.accept(moment.t);
}

std::vector<int> DrivenMotion::chosen_modes() const {
  forces_.choose_modes();
  return forces_.modes();
}

std::vector<double> DrivenMotion::line_angles() const {
  std::vector<double> lines;
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const ActingElement& e = forces_.element(k);
    if (!e.line.counts_turns) continue;
    lines.push_back(e.q_start);
    lines.push_back(e.rate_start);
  }
  return lines;
}

void DrivenMotion::set_line_angles(const std::vector<double>& lines,
                                   double t) const {
  std::size_t i = 0;
  for (std::size_t k = 0; i < lines.size(); ++k) {
    if (!forces_.element(k).line.counts_turns) continue;
    forces_.anchor(k, lines[i], lines[i + 1], t);
    i += 2;
  }
}

Motion DrivenMotion::run_through(const std::vector<double>& times,
                                 const std::vector<Configuration>& positions,
                                 const SimulationSettings& settings) const {
  Motion motion;
  motion.instants.reserve(times.size());
  path_.require_few_steps(settings.duration, settings.instants);
  first(settings, motion);
  for (std::size_t i = 1; i < times.size(); ++i) {
    motion.instants.push_back(
        instant(moment(positions[i], times[i]).at, times[i]));
  }
  judge_power_balance(definition_, motion);
  return motion;
}

Motion DrivenMotion::run_at(const std::vector<double>& times,
                            const SimulationSettings& settings) const {
  Motion motion;
  motion.instants.reserve(times.size());
  path_.require_few_steps(settings.duration, settings.instants);
  Moment last = first(settings, motion);  // that was regular
  std::optional<double> singular;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double t = times[i];
    if (t > last.t) {
      advance(last, singular, t, settings.at_singularity, motion);
    }
    // else between a start at a change point and a little beyond it
    ClosedConfiguration singular_there;
    if (last.t != t) singular_there = follow(last, t);
    const ClosedConfiguration& at = last.t == t ? last.at : singular_there;
    if (at.factor.full_column_rank()) {
      motion.instants.push_back(instant(at, t));
      continue;
    }
    std::optional<Instant> there;
    if (settings.at_singularity == AtSingularity::kContinue) {
      there = change_point(edge(last, t), t);
    }
    if (!there) refuse_change_point(at, t);
    motion.instants.push_back(std::move(*there));
  }
  if (singular) {
    settle(last, *singular, nullptr, settings.at_singularity, motion);
  }
  bracket_by_instants(motion.instants, motion.change_points);
  judge_power_balance(definition_, motion);
  return motion;
}

}  // namespace clevis::mechanism
