#include "mechanism/driven_trajectory/driven_trajectory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clevis::mechanism {

using Eigen::VectorXd;

namespace {

// Between two looks no body turns farther [rad]: nine a turn.
constexpr double kFarthestTurn = 0.7;

double fastest(const Instant& instant) {
  double most = 0.0;
  for (const BodyState& body : instant.bodies) {
    most = std::max(most, body.w_WL.norm());
  }
  return most;
}

}  // namespace

DrivenTrajectory::DrivenTrajectory(const MechanismDefinition& definition,
                                   const SimulationSettings& settings,
                                   DrivenMotion& motion)
    : settings_(settings),
      motion_(motion),
      loads_(definition, motion.model().frame.length),
      guards_(motion.instants().forces()) {}

DrivenTrajectory::Look DrivenTrajectory::look_at(const DrivenMoment& moment) {
  DrivenInstants& instants = motion_.instants();
  const auto [instant, acting] = instants.act_at(moment.at, moment.t);
  ++count_;
  Look look;
  look.t = moment.t;
  look.x = moment.at.x;
  look.loads = loads_.of(instant);
  look.turning = fastest(instant);
  const ForceModel& forces = instants.forces();
  look.guards = guards_.values(forces, acting, moment.t);
  look.rates = guards_.rates(acting);
  look.lines = instants.line_angles();
  return look;
}

const DrivenMoment& DrivenTrajectory::moment_of(At look) {
  motion_.instants().set_line_angles(look->lines, look->t);
  if (!moment_ || moment_->t != look->t) {
    moment_.emplace(motion_.model().moment(look->x, look->t));
  }
  return *moment_;
}

DrivenMoment DrivenTrajectory::follow(At left, double t) {
  return {motion_.model().follow(moment_of(left), t), t};
}

/// More looks between one and the next while a body turns far.
void DrivenTrajectory::turn_often(At left, std::size_t most) {
  const At right = std::next(left);
  const double h = right->t - left->t;
  const double turn = h * std::max(left->turning, right->turning);
  if (!(turn > kFarthestTurn) || looks_.size() >= most) return;
  const auto middle = look(left, 0.5 * (left->t + right->t));
  if (!middle) return;
  turn_often(left, most);
  turn_often(*middle, most);
}

bool DrivenTrajectory::walk(const std::vector<double>& times,
                            std::size_t most) {
  Motion passed;
  DrivenMoment last = motion_.start(passed);
  looks_.push_back(look_at(last));
  std::optional<double> singular;
  bool enough = true;
  for (const double t : times) {
    if (t <= last.t) continue;
    motion_.advance(last, singular, t, passed);
    if (last.t != t) continue;  // J has no full rank there
    looks_.push_back(look_at(last));
    turn_often(std::prev(looks_.end(), 2), most);
    motion_.instants().set_line_angles(looks_.back().lines, t);
    enough = looks_.size() < most;
  }
  change_points_ = std::move(passed.change_points);
  return enough;
}

std::optional<DrivenTrajectory::At> DrivenTrajectory::look(At left, double t) {
  const DrivenMoment there = follow(left, t);
  if (!there.at.factor.full_column_rank()) return std::nullopt;
  return looks_.insert(std::next(left), look_at(there));
}

ForceState DrivenTrajectory::forces_between(At left, double t) {
  ++count_;
  return motion_.instants().sense(follow(left, t));
}

VectorXd DrivenTrajectory::guards_between(At left, double t) {
  return guards_.values(forces(), forces_between(left, t), t);
}

bool DrivenTrajectory::matters_between(At left, double t, Eigen::Index guard) {
  return guards_.matters(guard, forces(), forces_between(left, t));
}

std::vector<int> DrivenTrajectory::modes_between(At left, double t) {
  return motion_.instants().choose_modes(forces_between(left, t));
}

}  // namespace clevis::mechanism
