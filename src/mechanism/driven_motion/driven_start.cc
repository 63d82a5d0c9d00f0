#include "mechanism/driven_motion/driven_start.h"

#include <cmath>
#include <utility>

#include <Eigen/QR>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/change_points/singular_start.h"
#include "mechanism/constraints/assembly.h"
#include "mechanism/constraints/closed_joints.h"
#include "mechanism/constraints/mobility.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/reactions/reaction_friction.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

[[noreturn]] void refuse_initial(const MechanismDefinition& definition,
                                 const std::string& place,
                                 std::string_view what, double violation) {
  const bool locked = definition.drives.empty();
  throw Error(
      "K007", place,
      fmt::format("{} fix the motion, and its {} at the start is "
                  "another than this one by {:.4g} mm{}",
                  locked ? "joints and couplings alone" : "the drives", what,
                  1e3 * violation, what == "velocity" ? "/s" : ""),
      locked ? "Leave this [[initial]] out, or look for couplings or "
               "joints that contradict one another."
             : "Leave this [[initial]] out, or change the drive.");
}

/// Compares [[initial]] with the start that the drives make.
/// @throws Error K007.
void require_agreement(const DrivenModel& model,
                       const ClosedConfiguration& at) {
  constexpr double kAgrees = 1e-6;
  for (const InitialJointState& initial : model.definition.initial_joints) {
    if (!initial.position) continue;
    DriveDefinition drive;
    drive.joint = initial.joint;
    const ConstraintSystem probe(model.frame, {drive}, model.system.motions(),
                                 ConstraintSystem::Drives::kAll);
    const VectorXd position = VectorXd::Constant(1, *initial.position);
    const double violation =
        std::abs(probe.residual(probe.place(at.x), position).tail(1)[0]);
    if (violation > kAgrees * model.frame.length) {
      refuse_initial(model.definition, initial.place, "position", violation);
    }
  }
  if (!at.factor.full_column_rank()) return;
  const WantedRates wanted =
      wanted_rates(model.definition, model.frame, model.system.motions(), at.x);
  const auto drives = static_cast<Index>(model.definition.drives.size());
  VectorXd rate = VectorXd::Zero(model.system.rows());
  rate.tail(drives) = wanted.rates.head(drives);
  const VectorXd v = at.factor.solve(rate);
  const double size = std::max(v.lpNorm<Eigen::Infinity>(),
                               wanted.rates.lpNorm<Eigen::Infinity>());
  Index row = drives;
  const auto compare = [&](const std::string& place, Index rows) {
    const double violation = (wanted.rows.middleRows(row, rows) * v -
                              wanted.rates.segment(row, rows))
                                 .lpNorm<Eigen::Infinity>();
    if (violation > kAgrees * size)
      refuse_initial(model.definition, place, "velocity", violation);
    row += rows;
  };
  for (const InitialJointState& initial : model.definition.initial_joints) {
    if (initial.rate) compare(initial.place, 1);
  }
  const auto bodies = static_cast<Index>(model.definition.bodies.size());
  for (const InitialBodyState& initial : model.definition.initial_bodies) {
    compare(initial.place, model.system.columns() / bodies);
  }
}

/// @throws Error K001, K003, K007.
ClosedConfiguration assembled_start(const DrivenModel& model) {
  require_driven(
      model.definition,
      mobility(model.frame, model.system,
               closed_joints(model.definition, model.frame, model.tolerance)));
  const VectorXd targets = drive_positions(model.definition, 0.0);
  const Assembled assembled =
      assemble(model.system, model.frame.placement, targets, model.tolerance,
               model.frame.rank_threshold());
  if (!assembled.closed) {
    refuse_open(model.definition,
                open_joints(model.definition, model.system, assembled.residual,
                            model.tolerance),
                "all joints with the drives at their start");
  }
  ClosedConfiguration closed = model.continuation.close(assembled.x, targets);
  require_agreement(model, closed);
  return closed;
}

/// The rates that single out the branch at a singular start: those of drives
/// and [[initial]], or the way of drives that start from rest.
/// @throws Error K005, K007.
WantedRates rates_on_branch(const DrivenModel& model,
                            const ClosedConfiguration& at, double duration) {
  WantedRates wanted =
      wanted_rates(model.definition, model.frame, model.system.motions(), at.x);
  const auto drives = static_cast<Index>(model.definition.drives.size());
  if (!wanted.rates.head(drives).isZero(0.0)) return wanted;
  if (!wanted.at_rest()) {
    refuse_rates(model.definition, wanted.rates.lpNorm<Eigen::Infinity>());
  }
  // a drive that starts from rest: the way that it goes
  VectorXd way = VectorXd::Zero(drives);
  for (int k = 40; k >= 0 && way.isZero(1e-9 * model.frame.length); --k) {
    const double t = std::ldexp(duration, -k);
    way = model.drive_rows(drive_positions(model.definition, t) - at.targets);
  }
  if (way.isZero(0.0)) model.refuse_change_point(at, 0.0);
  wanted.rows = MatrixXd(wanted.rows.topRows(drives));
  wanted.rates = way;
  return wanted;
}

/// A regular moment on the branch, a little after the start.
DrivenMoment leave(const DrivenModel& model, const SingularStart& start,
                   double duration) {
  constexpr double kAway = 2e-3, kAside = 0.1;  // of the length, of the way
  const BranchPoint& point = start.point;
  const VectorXd from = drive_positions(model.definition, 0.0);
  const Index drives = from.size();
  const MatrixXd rows =
      model.system.jacobian(model.system.place(point.x)).bottomRows(drives);
  const Eigen::ColPivHouseholderQR<MatrixXd> solver(rows * point.tangents);
  const auto way = [&](double t) {
    return VectorXd(point.tangents *
                    solver.solve(model.drive_rows(
                        drive_positions(model.definition, t) - from)));
  };
  const double wanted = kAway * model.frame.length;
  double near = 0.0, far = duration;
  for (int k = 40; k >= 0; --k) {
    far = std::ldexp(duration, -k);
    if (way(far).lpNorm<Eigen::Infinity>() >= wanted) break;
    near = far;
  }
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (near + far);
    (way(middle).lpNorm<Eigen::Infinity>() < wanted ? near : far) = middle;
  }
  const VectorXd step = way(far);
  Configuration x = point.x;
  model.system.move(x, step);
  const VectorXd targets = drive_positions(model.definition, far);
  const Assembled assembled = assemble(
      model.system, x, targets, model.tolerance, model.frame.rank_threshold());
  const double size = model.system.distance(point.x, x);
  ClosedConfiguration closed = model.continuation.close(assembled.x, targets);
  if (!assembled.closed || !closed.factor.full_column_rank() ||
      model.system.distance(x, assembled.x) > kAside * size) {
    model.refuse_change_point(closed, 0.0);
  }
  return {std::move(closed), far};
}

}  // namespace

DrivenMoment start_driven(const DrivenModel& model, DrivenInstants& instants,
                          const SimulationSettings& settings, Motion& motion) {
  refuse_friction_beside_teeth(model.definition, MovedBy::kDrives);
  ClosedConfiguration at = assembled_start(model);
  if (at.factor.full_column_rank()) {
    motion.instants.push_back(instants.regular(at, 0.0));
    return {std::move(at), 0.0};
  }
  if (settings.at_singularity != AtSingularity::kContinue) {
    model.refuse_change_point(at, 0.0);
  }
  const WantedRates wanted = rates_on_branch(model, at, settings.duration);
  const auto drives = static_cast<int>(model.definition.drives.size());
  const SingularStart start = singular_start(
      model.definition, model.frame, model.joints, at.x, wanted, drives);
  auto there = instants.singular(start.point.x, start.velocities, 0.0);
  if (!there) model.refuse_change_point(at, 0.0);
  motion.change_points.push_back({0.0, 0.0, 0.0, *there});
  motion.instants.push_back(std::move(*there));
  return leave(model, start, settings.duration);
}

}  // namespace clevis::mechanism
