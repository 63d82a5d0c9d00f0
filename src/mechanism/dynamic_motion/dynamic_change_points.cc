#include "mechanism/dynamic_motion/dynamic_change_points.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/equations_of_motion/branch_motion.h"
#include "mechanism/reactions/body_motion.h"
#include "mechanism/sampling/instant_brackets.h"

namespace clevis::mechanism {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Instant motion_at(const MechanismDefinition& definition,
                  const SolvingFrame& frame, const MechanismState& state,
                  const ForceModel& forces, double t,
                  const std::vector<SpatialAcceleration>& accelerations) {
  Instant instant;
  instant.t = t;
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    instant.bodies.push_back(body_motion(frame, static_cast<BodyIndex>(i),
                                         state.x[i + 1], state.twists[i + 1],
                                         accelerations[i + 1]));
  }
  instant.elements = forces.results(state.loads.forces);
  for (const DriveDefinition& drive : definition.drives) {
    const DriveTarget target = drive_target(drive, t);
    instant.drives.push_back({.position = target.position,
                              .rate = target.rate,
                              .acceleration = target.acceleration});
  }
  return instant;
}

void DynamicChangePoints::start(const InitialState& initial,
                                const VectorXd& y) {
  freedom_ = initial.freedom;
  rank_ = initial.rank;
  state_ = y;
  restart(y);
  last_speed_ = turning_speed(y);
  const ConstraintSystem& system = equations_.system();
  watch_.emplace(system.rows(), system.columns(), rank_,
                 model_.settings.tolerance);
  const auto jacobian = [&](double t, MatrixXd& J) {
    equations_.system().fill_jacobian(equations_.place(t, y).placed, J);
  };
  if (watch_->start(jacobian, 0.0)) note(0.0, state_);
}

/// Largest speed of an unknown over the length [1/s].
double DynamicChangePoints::turning_speed(const VectorXd& y) const {
  const StateLayout& layout = equations_.layout();
  return layout.largest_speed(y) / layout.length();
}

void DynamicChangePoints::look(numerics::Integrator& integrator, double until,
                               const VectorXd& end) {
  if (!has_loops_) return;  // the rows of a tree never depend on one another
  path_.follow(integrator, until, end);
  const auto jacobian = [&](double t, MatrixXd& J) {
    const VectorXd& y = path_.state_at(t);
    equations_.system().fill_jacobian(equations_.place(t, y).placed, J);
  };
  // by the speeds at both ends, which may be passed in between
  constexpr double kPassed = 2.0;
  const double speed = turning_speed(end);
  const double fastest = kPassed * std::max(speed, last_speed_);
  last_speed_ = speed;
  note_all(watch_->look(jacobian, until, fastest));
  const std::vector<double>& awaited = watch_->awaited();
  std::erase_if(candidates_, [&](const Candidate& candidate) {
    return std::ranges::find(awaited, candidate.t) == awaited.end();
  });
  for (const double t : awaited) {
    if (std::ranges::find(candidates_, t, &Candidate::t) == candidates_.end()) {
      candidates_.push_back({t, path_.state_at(t)});
    }
  }
}

void DynamicChangePoints::finish() {
  if (has_loops_) note_all(watch_->finish());
}

void DynamicChangePoints::note_all(const std::vector<double>& zeros) {
  for (const double t : zeros) {
    const auto known = std::ranges::find(candidates_, t, &Candidate::t);
    state_ = known == candidates_.end() ? path_.state_at(t) : known->state;
    note(t, state_);
  }
}

void DynamicChangePoints::note(double t, VectorXd& y) {
  if (model_.settings.at_singularity == AtSingularity::kStop) {
    throw Error(
        "K005", "mechanism",
        fmt::format("at t = {:.9g} s the motion passes a change point", t),
        "End the motion before, change lengths or forces, or let "
        "at_singularity be \"report\" or \"continue\".");
  }
  ChangePoint point{.t_before = t, .t_after = t, .t = t};
  // costs more than the motion itself: only where it is wanted
  const bool is_sought =
      model_.settings.at_singularity == AtSingularity::kContinue ||
      std::ranges::any_of(model_.definition.joints, [](const auto& joint) {
        return joint.compliance.has_value();
      });
  if (is_sought) {
    model_.projection.project(t, y);
    auto found = on_branch(t, y);
    if (found && found->forces) {
      point.at = motion_at(model_.definition, model_.frame, equations_.state(),
                           equations_.forces(), t, found->accelerations);
      put_forces(model_.frame, equations_.system(), equations_.state().placed,
                 std::move(*found->forces), *point.at);
      point.at->is_change_point = true;
    }
  }
  points_.push_back(std::move(point));
}

std::optional<DynamicChangePoints::OnBranch> DynamicChangePoints::on_branch(
    double t, const VectorXd& y) {
  const ConstraintSystem& system = equations_.system();
  const auto found = branch_motion(equations_, model_.frame, t, y, freedom_);
  if (!found) return std::nullopt;
  OnBranch result{.accelerations = system.twists(found->accelerations),
                  .forces = {}};
  const std::vector<Twist>& twists = equations_.state().twists;
  std::vector<SpatialForce> applied(twists.size());
  equations_.forces().add_to(equations_.state().loads.forces, applied);
  const Configuration x = with_quaternions(equations_.state().x);
  result.forces = model_.equilibrium.solve_compliant(
      x, system.place(x), twists, result.accelerations, applied, found->open);
  return result;
}

std::vector<ChangePoint> DynamicChangePoints::among(
    const std::vector<Instant>& instants) && {
  bracket_by_instants(instants, points_);
  return std::move(points_);
}

}  // namespace clevis::mechanism
