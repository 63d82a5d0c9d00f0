#include "mechanism/driven_motion/driven_model.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/index.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

DrivenModel::DrivenModel(const MechanismDefinition& given,
                         const SimulationSettings& settings)
    : definition(given),
      frame(given),
      system(frame, given.drives,
             frame.planar ? Motions::kInPlane : Motions::kSpatial,
             ConstraintSystem::Drives::kAll),
      joints(frame, {}, system.motions(), ConstraintSystem::Drives::kNone),
      tolerance(settings.tolerance * frame.length),
      continuation(system, tolerance),
      equilibrium(given, frame, system),
      duration_(settings.duration),
      limit_(settings.max_time, settings.duration, 1) {}

void DrivenModel::require_in_time(double t) const {
  constexpr long kLook = 16;  // positions: the clock is a system call
  if (++asked_ % kLook != 0 || !limit_.is_used_up()) return;
  throw Error(
      "K013", "mechanism",
      fmt::format("{:.2g} s of processor time and {} positions of a motion "
                  "that the drives fix have been found, the last at t = {:.6g} "
                  "s of {:.6g} s; {:.4g} s are allowed",
                  limit_.used(), asked_, t, duration_, limit_.limit()),
      "See that the units of the duration and of the drives' speeds are right; "
      "else give more --max-time, fewer instants, a shorter motion, drives "
      "without needless turns.");
}

ClosedConfiguration DrivenModel::follow(const DrivenMoment& from,
                                        double t) const {
  require_in_time(t);
  Continuation::Reached reached =
      continuation.follow(from.at, drive_positions(definition, t));
  if (reached.part < 1.0) stop(from, reached, t);
  return std::move(reached.at);
}

DrivenMoment DrivenModel::moment(const Configuration& x, double t) const {
  require_in_time(t);
  return {continuation.close(x, drive_positions(definition, t)), t};
}

VectorXd DrivenModel::drive_rows(const VectorXd& values) const {
  VectorXd rows = values;
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    rows[i] *= system.scale(system.row_list()[index(system.joint_rows() + i)]);
  }
  return rows;
}

void DrivenModel::refuse_change_point(const ClosedConfiguration& at,
                                      double t) const {
  throw Error(
      "K005", "mechanism",
      fmt::format("at t = {:.6g} s ({}) the constraint Jacobian loses "
                  "rank: {} of {}",
                  t, drives_at(definition, at.targets, 6),
                  std::min(at.factor.rank(), system.columns() - 1),
                  system.columns()),
      "Choose instants, lengths or a range of the drive that avoid "
      "this position, where the branch is undetermined and rigid "
      "reactions have no bound, or let at_singularity be \"continue\".");
}

/// The drives' coordinates at which the branch ends, by the square of the
/// smallest singular value, which falls linearly to zero there.
/// @param targets  beyond the end.
VectorXd DrivenModel::dead_end(const Continuation::Reached& reached,
                               const VectorXd& targets) const {
  constexpr double kBack = 1e-6;
  const ClosedConfiguration& last = reached.at;
  if (!last.factor.full_column_rank()) return targets;
  const VectorXd back = -kBack * (targets - last.targets);
  const Continuation::Reached behind =
      continuation.follow(last, last.targets + back);
  if (behind.part < 1.0 || !behind.at.factor.full_column_rank()) {
    return last.targets;
  }
  const double here = std::pow(last.factor.weakest().sigma, 2);
  const double there = std::pow(behind.at.factor.weakest().sigma, 2);
  const double beyond = here / (there - here);
  if (!(beyond > 0.0 && beyond < 1.0)) return last.targets;
  return last.targets - beyond * back;
}

void DrivenModel::stop(const DrivenMoment& from,
                       const Continuation::Reached& reached, double t) const {
  const VectorXd end = dead_end(reached, drive_positions(definition, t));
  // when the drive that moves most is there
  const VectorXd way = end - from.at.targets;
  Eigen::Index k = 0;
  way.cwiseAbs().maxCoeff(&k);
  double before = from.t, after = t;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (before + after);
    const double moved =
        drive_positions(definition, middle)[k] - from.at.targets[k];
    (moved / way[k] < 1.0 ? before : after) = middle;
  }
  throw Error("K004", "mechanism",
              fmt::format("at t = {:.9g} s the mechanism stops at {}: beyond "
                          "it no position continues the motion",
                          before, drives_at(definition, end, 11)),
              "Reduce the range of the drive, or correct the lengths.");
}

}  // namespace clevis::mechanism
