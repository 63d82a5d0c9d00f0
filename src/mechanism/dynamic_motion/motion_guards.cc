#include "mechanism/dynamic_motion/motion_guards.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/algebra/singular_vectors.h"
#include "base/messages/errors.h"
#include "base/values/index.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/dynamic_motion/fastest_rate.h"
#include "mechanism/forces/element_modes.h"
#include "mechanism/reactions/reaction_friction.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

namespace {

/// What to do first: wait, if that is all; else look at what is fastest.
std::string time_remedy(const TimeLimit& limit, const std::string& fastest) {
  const std::string look =
      fastest.empty() ? "the scene" : fmt::format("the values of {},", fastest);
  if (const auto enough = limit.enough()) {
    return fmt::format(
        "Give --max-time \"{:g} s\", by the forecast enough; or a shorter "
        "motion, a looser tolerance. If that is too long, look at {} for a "
        "wrong order of size.",
        *enough, look);
  }
  return fmt::format(
      "Look at {} for a wrong order of size. If it is meant: a shorter motion, "
      "a looser tolerance, or more --max-time.",
      look);
}

}  // namespace

bool MotionGuards::are_events_crowded(double t) {
  constexpr int kMost = 200;
  const double crowd = 1e-9 * model_.settings.duration;
  crowded_events_ = t - last_event_ < crowd ? crowded_events_ + 1 : 0;
  last_event_ = t;
  return crowded_events_ >= kMost;
}

void MotionGuards::refuse_crowded_events(double t) {
  throw Error("K008", "mechanism",
              fmt::format("at t = {:.9g} s events of contact or friction "
                          "follow one another without end",
                          t),
              "Give the contact damping, or the friction model = "
              "\"regularized\".");
}

void MotionGuards::require_closed(double t, double gap) {
  constexpr double kClosed = 1e-6;
  const double allowed = std::max(kClosed, model_.settings.tolerance);
  if (gap <= allowed * model_.frame.length) return;
  refuse_dead_end();
  throw Error(
      "K012", "mechanism",
      fmt::format("at t = {:.9g} s joints or drives are open by {:.3g} mm: "
                  "the integration failed",
                  t, 1e3 * gap),
      "Ask for a stricter tolerance, and look for drives or joints "
      "that contradict one another.");
}

void MotionGuards::require_resisting_friction(const VectorXd& y) {
  const ForceModel& forces = model_.equations.forces();
  if (forces.empty()) return;
  const MechanismState& state =
      model_.equations.evaluate_forces(integrator_.t(), y);
  const std::size_t k = line_against_its_mode(forces, state.loads.forces);
  if (k == forces.size()) return;
  const ForceElement& element = model_.definition.elements[k];
  throw Error("K012", place_of(element),
              fmt::format("at t = {:.9g} s friction {} moves its line instead "
                          "of resisting: the integration failed",
                          integrator_.t(), name_of(element)),
              "Ask for a stricter tolerance, or give the friction model = "
              "\"regularized\".");
}

/// The combination of rows that is nearest to vanishing.
MotionGuards::WeakestRows MotionGuards::weakest_rows() {
  constexpr double kBeside = 1e-2;  // of the largest singular value
  const ConstraintSystem& system = model_.equations.system();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(system.rows(), system.columns());
  const MechanismState& state =
      model_.equations.place(integrator_.t(), integrator_.y());
  system.fill_jacobian(state.placed, J);
  const int rank = change_points_.rank();
  if (rank < 1) return {};
  const SingularVectors found = singular_vectors(J);
  return {found.sigma[rank - 1] < kBeside * found.sigma[0],
          found.U.col(rank - 1)};
}

void MotionGuards::refuse_dead_end() {
  constexpr double kPart = 0.1;
  const MechanismDefinition& definition = model_.definition;
  const WeakestRows weakest = weakest_rows();
  if (!weakest.beside || definition.drives.empty()) return;
  const ConstraintSystem& system = model_.equations.system();
  const auto count = static_cast<Eigen::Index>(definition.drives.size());
  const double t = integrator_.t();
  VectorXd rates(count), positions(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const DriveTarget target = drive_target(definition.drives[index(k)], t);
    const auto row = index(system.joint_rows() + k);
    rates[k] = system.scale(system.row_list()[row]) * target.rate;
    positions[k] = target.position;
  }
  const double against = weakest.row.tail(count).dot(rates);
  if (!(std::abs(against) > kPart * rates.norm())) return;
  throw Error("K004", "mechanism",
              fmt::format("at t = {:.6g} s the mechanism stops at {}: beyond "
                          "it no position continues the motion",
                          t, drives_at(definition, positions, 6)),
              "Reduce the range of the drive, or correct the lengths.");
}

void MotionGuards::refuse_stuck() {
  if (const auto jammed = model_.equations.self_locking()) {
    refuse_self_locking(model_.definition, *jammed, integrator_.t());
  }
  refuse_dead_end();
  if (weakest_rows().beside) {
    throw Error("K008", "mechanism",
                fmt::format("at t = {:.9g} s no step is short enough: beside a "
                            "change point, where rigid reactions, and friction "
                            "that follows them, grow without bound",
                            integrator_.t()),
                "Give the friction itself, change the lengths so that the "
                "change point is not met, or end the motion before.");
  }
  const FastestRate fastest =
      fastest_rate(model_, integrator_.t(), integrator_.y());
  throw Error(
      "K008", "mechanism",
      fmt::format("at t = {:.9g} s no step is short enough{}", integrator_.t(),
                  fastest.what.empty()
                      ? ""
                      : fmt::format("; fastest is {} ({:.2g} 1/s)",
                                    fastest.what, fastest.rate)),
      fastest.what.empty()
          ? "Look for forces or lengths of a wrong order of size."
          : "Look for forces, masses or lengths of a wrong order of size, "
            "first "
            "there.");
}

void MotionGuards::require_in_time() {
  constexpr long kLook = 16;  // steps: the clock is a system call
  if (++steps_ % kLook != 0) return;
  const auto& progress = model_.settings.progress;
  if (progress) progress(limit_.share(integrator_.t()));
  if (!limit_.is_over(integrator_.t())) return;
  const numerics::StepCounts& counts = integrator_.counts();
  const FastestRate fastest =
      fastest_rate(model_, integrator_.t(), integrator_.y());
  throw Error(
      "K013", "mechanism",
      fmt::format(
          "{:.2g} s of processor time and {} steps by {} have reached t = "
          "{:.6g} s of {:.6g} s, forecast {:.2g} s in all, {:.4g} s are "
          "allowed; fastest is {} ({:.2g} 1/s)",
          limit_.used(), counts.steps, integrator_.method(), integrator_.t(),
          model_.settings.duration, limit_.forecast(), limit_.limit(),
          fastest.what, fastest.rate),
      time_remedy(limit_, fastest.what));
}

}  // namespace clevis::mechanism
