#include "mechanism/driven_motion.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/body_motion.h"
#include "mechanism/drive_law.h"
#include "mechanism/power_balance.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

std::string DrivenMotion::drives_at(const VectorXd& targets) const {
  std::string text;
  for (std::size_t i = 0; i < definition_.drives.size(); ++i) {
    const DriveDefinition& drive = definition_.drives[i];
    const std::string name = drive_name(definition_, drive);
    const double q = targets[static_cast<Eigen::Index>(i)];
    text += text.empty() ? "" : ", ";
    text += drives_angle(definition_, drive)
                ? fmt::format("{} at {:.6g} deg", name,
                              q * 180.0 / std::numbers::pi)
                : fmt::format("{} at {:.6g} mm", name, 1e3 * q);
  }
  return text;
}

void DrivenMotion::require_regular(const ClosedConfiguration& at,
                                   double t) const {
  if (!at.factor.full_column_rank()) refuse_change_point(at, t);
}

void DrivenMotion::refuse_change_point(const ClosedConfiguration& at,
                                       double t) const {
  throw Error("K005", "mechanism",
              fmt::format("at t = {:.6g} s ({}) the constraint Jacobian loses "
                          "rank: {} of {}",
                          t, drives_at(at.targets),
                          std::min(at.factor.rank(), system_.columns() - 1),
                          system_.columns()),
              "choose instants, lengths or a range of the drive that avoid "
              "this position, where the branch is undetermined and rigid "
              "reactions have no bound, or let at_singularity be \"continue\"");
}

void DrivenMotion::stop(const Continuation::Reached& reached, double t) const {
  throw Error("K004", "mechanism",
              fmt::format("before t = {:.6g} s the mechanism stops at {}: "
                          "beyond it no position continues the motion",
                          t, drives_at(reached.at.targets)),
              "reduce the range of the drive, or correct the lengths");
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
  const std::vector<Twist> applied = elements(at, motion, result);
  put_forces(frame_, system_, at.placed,
             equilibrium_.solve(at.x, at.placed, at.factor, motion.twists,
                                motion.accelerations, applied),
             result);
  return result;
}

ClosedConfiguration DrivenMotion::follow(const ClosedConfiguration& from,
                                         double t) const {
  Continuation::Reached reached =
      continuation_.follow(from, drive_positions(definition_, t));
  if (reached.part < 1.0) stop(reached, t);
  return std::move(reached.at);
}

Motion DrivenMotion::run(const SimulationSettings& settings) const {
  Motion motion;
  Moment last(start(), 0.0);  // that was regular
  require_regular(last.at, 0.0);
  const int n = settings.instants;
  motion.instants.reserve(static_cast<std::size_t>(n));
  motion.instants.push_back(instant(last.at, 0.0));
  for (int i = 1; i < n; ++i) {
    const double t = settings.duration * i / (n - 1);
    Moment next(follow(last.at, t), t);
    if (settings.at_singularity == AtSingularity::kContinue &&
        !next.at.factor.full_column_rank()) {
      auto singular = change_point(last, t, t - last.t);
      if (!singular) require_regular(next.at, t);
      motion.instants.push_back(std::move(*singular));
      continue;
    }
    require_regular(next.at, t);
    note_change_points(last, next, settings.at_singularity, motion);
    last = std::move(next);
    motion.instants.push_back(instant(last.at, t));
  }
  if (motion.instants.back().is_change_point) {
    const Instant& at = motion.instants.back();
    motion.change_points.push_back({last.t, at.t, at.t, at});
  }
  judge_power_balance(definition_, motion);
  return motion;
}

}  // namespace clevis::mechanism
