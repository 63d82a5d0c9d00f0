#include "mechanism/driven_motion/driven_instants.h"

#include <span>
#include <utility>

#include <Eigen/QR>

#include "base/values/index.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/forces/element_modes.h"
#include "mechanism/reactions/body_motion.h"
#include "mechanism/reactions/reaction_friction.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

DrivenInstants::Rates DrivenInstants::rates(const ClosedConfiguration& at,
                                            double t) const {
  const ConstraintSystem& system = model_.system;
  VectorXd rate = VectorXd::Zero(system.rows());
  VectorXd second = VectorXd::Zero(system.rows());
  for (std::size_t k = 0; k < model_.definition.drives.size(); ++k) {
    const auto row = static_cast<std::size_t>(system.joint_rows()) + k;
    const double scale = system.scale(system.row_list()[row]);
    const DriveTarget target = drive_target(model_.definition.drives[k], t);
    rate[static_cast<Index>(row)] = scale * target.rate;
    second[static_cast<Index>(row)] = scale * target.acceleration;
  }
  Rates result;
  result.twists = system.twists(at.factor.solve(rate));
  second -= system.bias(at.placed, result.twists);
  result.accelerations = system.twists(at.factor.solve(second));
  return result;
}

/// Velocities G z and accelerations G z' + G' z of the branch G that the drives
/// ask for. @return nothing where they do not move along it.
std::optional<DrivenInstants::Rates> DrivenInstants::branch_rates(
    const BranchPoint& point, const VectorXd& along, double t) const {
  const ConstraintSystem& system = model_.system;
  const auto placed = system.place(point.x);
  const auto drives = static_cast<Index>(model_.definition.drives.size());
  const MatrixXd rows = system.jacobian(placed).bottomRows(drives);
  const Eigen::ColPivHouseholderQR<MatrixXd> solver(rows * point.tangents);
  if (!solver.isInvertible()) return std::nullopt;
  VectorXd rate(drives), second(drives);
  for (Index i = 0; i < drives; ++i) {
    const DriveTarget target =
        drive_target(model_.definition.drives[index(i)], t);
    rate[i] = target.rate;
    second[i] = target.acceleration;
  }
  const VectorXd z = solver.solve(model_.drive_rows(rate));
  const VectorXd v = point.tangents * z;
  const VectorXd curved =
      v.dot(along) / along.squaredNorm() * (point.slopes * z);
  Rates result;
  result.twists = system.twists(v);
  const VectorXd bias = system.bias(placed, result.twists).tail(drives);
  const VectorXd change =
      solver.solve(model_.drive_rows(second) - bias - rows * curved);
  result.accelerations = system.twists(curved + point.tangents * change);
  return result;
}

/// Positions, drives and rates of an instant; no forces.
Instant DrivenInstants::kinematics(const ClosedConfiguration& at, double t,
                                   const Rates& rates) const {
  Instant result;
  result.t = t;
  for (const DriveDefinition& drive : model_.definition.drives) {
    const DriveTarget target = drive_target(drive, t);
    result.drives.push_back({.position = target.position,
                             .rate = target.rate,
                             .acceleration = target.acceleration});
  }
  const std::size_t count = model_.definition.bodies.size();
  result.bodies.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.bodies.push_back(body_motion(model_.frame, static_cast<BodyIndex>(i),
                                        at.x[i + 1], rates.twists[i + 1],
                                        rates.accelerations[i + 1]));
  }
  result.closure_error = at.gap;
  return result;
}

/// Lets the force elements act, in the modes of this state.
ForceState DrivenInstants::act(const ClosedConfiguration& at, double t,
                               const Rates& rates) {
  ForceState acting = forces_.none();
  forces_.evaluate(t, at.x, rates.twists, nullptr, acting);
  mechanism::choose_modes(acting, forces_);
  forces_.evaluate(t, at.x, rates.twists, nullptr, acting);
  forces_.accept(t, acting);
  return acting;
}

DrivenInstants::Acted DrivenInstants::act_at(const ClosedConfiguration& at,
                                             double t) {
  const Rates motion = rates(at, t);
  Acted result{.instant = kinematics(at, t, motion),
               .forces = act(at, t, motion)};
  const auto balance = [&](std::span<const SpatialForce> applied) {
    const auto elements = model_.frame.links.empty()
                              ? std::vector<ElementState>{}
                              : forces_.results(result.forces);
    return model_.equilibrium.solve(at.x, at.placed, at.factor, motion.twists,
                                    motion.accelerations, applied, elements);
  };
  put_forces(model_.frame, model_.system, at.placed,
             balance_with_friction(model_.definition, forces_, result.forces,
                                   at.x.size(), balance),
             result.instant);
  result.instant.elements = forces_.results(result.forces);
  require_unique_loads(model_.definition, forces_, result.forces,
                       result.instant.joints);
  return result;
}

std::optional<Instant> DrivenInstants::singular(const Configuration& x,
                                                const VectorXd& along,
                                                double t) {
  const auto drives = static_cast<int>(model_.definition.drives.size());
  const auto point = branch_point(model_.joints, x, along, drives);
  if (!point) return std::nullopt;
  const auto here = branch_rates(*point, along, t);
  if (!here) return std::nullopt;
  const ClosedConfiguration at = model_.moment(point->x, t).at;
  Instant result = kinematics(at, t, *here);
  const ForceState acting = act(at, t, *here);
  std::vector<SpatialForce> applied(at.x.size());
  forces_.add_to(acting, applied);
  result.elements = forces_.results(acting);
  auto forces = model_.equilibrium.solve_compliant(
      at.x, at.placed, here->twists, here->accelerations, applied);
  if (!forces) return std::nullopt;
  put_forces(model_.frame, model_.system, at.placed, std::move(*forces),
             result);
  result.is_change_point = true;
  return result;
}

ForceState DrivenInstants::sense(const DrivenMoment& moment) {
  ForceState acting = forces_.none();
  forces_.evaluate(moment.t, moment.at.x, rates(moment.at, moment.t).twists,
                   nullptr, acting);
  forces_.accept(moment.t, acting);
  return acting;
}

std::vector<int> DrivenInstants::choose_modes(const ForceState& state) {
  mechanism::choose_modes(state, forces_);
  return modes(forces_);
}

std::vector<double> DrivenInstants::line_angles() const {
  std::vector<double> lines;
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const ActingElement& e = forces_.element(k);
    if (!e.line.counts_turns) continue;
    lines.push_back(e.anchor.q);
    lines.push_back(e.anchor.rate);
  }
  return lines;
}

void DrivenInstants::set_line_angles(const std::vector<double>& lines,
                                     double t) {
  std::size_t i = 0;
  for (std::size_t k = 0; i < lines.size(); ++k) {
    ActingElement& e = forces_.element(k);
    if (!e.line.counts_turns) continue;
    e.anchor = {lines[i], lines[i + 1], t};
    i += 2;
  }
}

}  // namespace clevis::mechanism
