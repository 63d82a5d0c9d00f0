// Where a driven motion starts.
#include <cmath>
#include <utility>

#include <Eigen/QR>
#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/change_points/singular_start.h"
#include "mechanism/constraints/assembly.h"
#include "mechanism/constraints/closed_joints.h"
#include "mechanism/constraints/mobility.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/driven_motion/driven_motion.h"
#include "mechanism/drives/drive_law.h"

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

}  // namespace

/// What [[initial]] says must be what the drives make of the start.
/// @throws Error K007.
void DrivenMotion::require_agreement(const ClosedConfiguration& at) const {
  constexpr double kAgrees = 1e-6;
  for (const InitialJointState& initial : definition_.initial_joints) {
    if (!initial.position) continue;
    DriveDefinition drive;
    drive.joint = initial.joint;
    const ConstraintSystem probe(frame_, {drive}, system_.motions(),
                                 ConstraintSystem::Drives::kAll);
    const VectorXd position = VectorXd::Constant(1, *initial.position);
    const double violation =
        std::abs(probe.residual(probe.place(at.x), position).tail(1)[0]);
    if (violation > kAgrees * frame_.length) {
      refuse_initial(definition_, initial.place, "position", violation);
    }
  }
  if (!at.factor.full_column_rank()) return;
  const WantedRates wanted =
      wanted_rates(definition_, frame_, system_.motions(), at.x);
  const auto drives = static_cast<Index>(definition_.drives.size());
  VectorXd rate = VectorXd::Zero(system_.rows());
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
      refuse_initial(definition_, place, "velocity", violation);
    row += rows;
  };
  for (const InitialJointState& initial : definition_.initial_joints) {
    if (initial.rate) compare(initial.place, 1);
  }
  const auto bodies = static_cast<Index>(definition_.bodies.size());
  for (const InitialBodyState& initial : definition_.initial_bodies) {
    compare(initial.place, system_.columns() / bodies);
  }
}

ClosedConfiguration DrivenMotion::start() const {
  require_driven(definition_,
                 mobility(frame_, system_,
                          closed_joints(definition_, frame_, tolerance_)));
  const VectorXd targets = drive_positions(definition_, 0.0);
  const Assembled assembled = assemble(system_, frame_.placement, targets,
                                       tolerance_, frame_.rank_threshold());
  if (!assembled.closed) {
    refuse_open(
        open_joints(definition_, system_, assembled.residual, tolerance_),
        "all joints with the drives at their start");
  }
  ClosedConfiguration closed = continuation_.close(assembled.x, targets);
  require_agreement(closed);
  return closed;
}

/// The first instant, and the first regular moment.
/// @throws Error K005 if that is none and must not be, K007, K010.
DrivenMotion::Moment DrivenMotion::first(const SimulationSettings& settings,
                                         Motion& motion) const {
  ClosedConfiguration at = start();
  if (at.factor.full_column_rank()) {
    motion.instants.push_back(instant(at, 0.0));
    return {std::move(at), 0.0};
  }
  if (settings.at_singularity != AtSingularity::kContinue) {
    refuse_change_point(at, 0.0);
  }
  WantedRates wanted =
      wanted_rates(definition_, frame_, system_.motions(), at.x);
  const auto drives = static_cast<Index>(definition_.drives.size());
  if (wanted.rates.head(drives).isZero(0.0)) {
    if (!wanted.at_rest()) {
      refuse_rates(definition_, wanted.rates.lpNorm<Eigen::Infinity>());
    }
    // a drive that starts from rest: the way that it goes
    VectorXd way = VectorXd::Zero(drives);
    for (int k = 40; k >= 0 && way.isZero(1e-9 * frame_.length); --k) {
      const double t = std::ldexp(settings.duration, -k);
      way = drive_rows(drive_positions(definition_, t) - at.targets);
    }
    if (way.isZero(0.0)) refuse_change_point(at, 0.0);
    wanted.rows = MatrixXd(wanted.rows.topRows(drives));
    wanted.rates = way;
  }
  const SingularStart start = singular_start(definition_, frame_, joints_, at.x,
                                             wanted, static_cast<int>(drives));
  auto there = on_branch(start.point.x, start.velocities, 0.0);
  if (!there) refuse_change_point(at, 0.0);
  motion.change_points.push_back({0.0, 0.0, 0.0, *there});
  motion.instants.push_back(std::move(*there));
  return leave(start, settings.duration);
}

/// A regular moment on the branch, a little after the start.
DrivenMotion::Moment DrivenMotion::leave(const SingularStart& start,
                                         double duration) const {
  constexpr double kAway = 2e-3, kAside = 0.1;  // of the length, of the way
  const BranchPoint& point = start.point;
  const VectorXd from = drive_positions(definition_, 0.0);
  const Index drives = from.size();
  const MatrixXd rows =
      system_.jacobian(system_.place(point.x)).bottomRows(drives);
  const Eigen::ColPivHouseholderQR<MatrixXd> solver(rows * point.tangents);
  const auto way = [&](double t) {
    return VectorXd(
        point.tangents *
        solver.solve(drive_rows(drive_positions(definition_, t) - from)));
  };
  const double wanted = kAway * frame_.length;
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
  system_.move(x, step);
  const VectorXd targets = drive_positions(definition_, far);
  const Assembled assembled =
      assemble(system_, x, targets, tolerance_, frame_.rank_threshold());
  const double size = system_.distance(point.x, x);
  ClosedConfiguration closed = continuation_.close(assembled.x, targets);
  if (!assembled.closed || !closed.factor.full_column_rank() ||
      system_.distance(x, assembled.x) > kAside * size) {
    refuse_change_point(closed, 0.0);
  }
  return {std::move(closed), far};
}

}  // namespace clevis::mechanism
