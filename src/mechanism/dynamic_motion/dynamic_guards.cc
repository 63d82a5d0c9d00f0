// What ends an integrated motion before its time.
#include <algorithm>
#include <cmath>
#include <variant>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/dynamic_motion/dynamic_run.h"
#include "mechanism/reactions/reaction_friction.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

void DynamicRun::guard_against_accumulation(double t) {
  constexpr int kMost = 200;
  const double crowd = 1e-9 * settings_.duration;
  crowded_events_ = t - last_event_ < crowd ? crowded_events_ + 1 : 0;
  last_event_ = t;
  if (crowded_events_ < kMost) return;
  refuse_dead_end();
  state_at(t, y_);
  add_instant(t, y_);
  refuse_open_loads(definition_, dynamics_.forces(),
                    motion_.instants.back().joints);
  throw Error("K008", "mechanism",
              fmt::format("at t = {:.9g} s events of contact or friction "
                          "follow one another without end",
                          t),
              "give the contact damping, or the friction model = "
              "\"regularized\"");
}

/// What kinetic energy and work differ by.
double DynamicRun::energy_gap(const VectorXd& y) {
  return std::abs(dynamics_.kinetic_energy(y) - energy_start_ -
                  y[dynamics_.work_index()]);
}

void DynamicRun::note_energy(const VectorXd& y) {
  const double kinetic = dynamics_.kinetic_energy(y);
  const double work = y[dynamics_.work_index()];
  energy_error_ = std::max(energy_error_, energy_gap(y));
  largest_energy_ = std::max({largest_energy_, kinetic, std::abs(work)});
  largest_load_ = std::max(largest_load_, dynamics_.largest_load());
}

/// Kinetic energy and work must agree: to a part of the largest of them, or to
/// what the largest force does over the error of positions that is allowed.
void DynamicRun::require_energy_balance() const {
  constexpr double kPart = 0.01, kTimesAllowed = 100.0;
  const double allowed =
      std::max(kPart, kTimesAllowed * settings_.tolerance) * largest_energy_ +
      kTimesAllowed * settings_.tolerance * frame_.length * largest_load_;
  if (energy_error_ <= allowed) return;
  throw Error("K012", "mechanism",
              fmt::format("kinetic energy and the work of all forces differ by "
                          "{:.3g} J, {:.2g} of the largest: the integration "
                          "failed",
                          energy_error_, energy_error_ / largest_energy_),
              "ask for a stricter tolerance, and look for lengths, masses or "
              "forces of a wrong order of size");
}

void DynamicRun::require_closed(double t, double gap) {
  constexpr double kClosed = 1e-6;
  if (gap <= std::max(kClosed, settings_.tolerance) * frame_.length) return;
  refuse_dead_end();
  throw Error("K012", "mechanism",
              fmt::format("at t = {:.9g} s joints or drives gape by {:.3g} mm: "
                          "the integration failed",
                          t, 1e3 * gap),
              "ask for a stricter tolerance, and look for drives or joints "
              "that contradict one another");
}

/// Friction at rest holds, friction that slips resists.
void DynamicRun::require_resisting_friction() {
  if (dynamics_.forces().empty()) return;
  dynamics_.evaluate_forces(integrator_.t(), y_);
  const std::size_t k = dynamics_.forces().line_against_its_mode();
  if (k == dynamics_.forces().size()) return;
  throw Error("K012", place_of(definition_.elements[k]),
              fmt::format("at t = {:.9g} s friction {} moves its line instead "
                          "of resisting: the integration failed",
                          integrator_.t(), name_of(definition_.elements[k])),
              "ask for a stricter tolerance, or give the friction model = "
              "\"regularized\"");
}

bool DynamicRun::is_beside_change_point() {
  return weakest_rows().beside;
}

/// The combination of rows that is nearest to vanishing.
DynamicRun::WeakestRows DynamicRun::weakest_rows() {
  constexpr double kBeside = 1e-2;  // of the largest singular value
  const ConstraintSystem& system = dynamics_.system();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(system.rows(), system.columns());
  dynamics_.jacobian(integrator_.t(), integrator_.y(), J);
  const int rank = change_points_.rank();
  if (rank < 1) return {};
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU);
  const VectorXd& values = svd.singularValues();
  return {values[rank - 1] < kBeside * values[0], svd.matrixU().col(rank - 1)};
}

/// Where what drives go on to do meets rows that fade, no position leads on.
/// @throws Error K004 there.
void DynamicRun::refuse_dead_end() {
  constexpr double kPart = 0.1;
  const WeakestRows weakest = weakest_rows();
  if (!weakest.beside || definition_.drives.empty()) return;
  const ConstraintSystem& system = dynamics_.system();
  const auto count = static_cast<Eigen::Index>(definition_.drives.size());
  const double t = integrator_.t();
  VectorXd rates(count), positions(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto row = static_cast<std::size_t>(system.joint_rows()) + i;
    const DriveTarget target = drive_target(definition_.drives[i], t);
    rates[k] = system.scale(system.row_list()[row]) * target.rate;
    positions[k] = target.position;
  }
  const double against = weakest.row.tail(count).dot(rates);
  if (!(std::abs(against) > kPart * rates.norm())) return;
  throw Error("K004", "mechanism",
              fmt::format("at t = {:.6g} s the mechanism stops at {}: beyond "
                          "it no position continues the motion",
                          t, drives_at(definition_, positions, 6)),
              "reduce the range of the drive, or correct the lengths");
}

/// No step is short enough.
void DynamicRun::refuse_stuck() {
  if (dynamics_.jams()) refuse_jam(integrator_.t());
  refuse_dead_end();
  const bool beside = is_beside_change_point();
  throw Error(
      "K008", "mechanism",
      fmt::format("at t = {:.9g} s no step is short enough{}", integrator_.t(),
                  beside ? ": beside a change point, where rigid "
                           "reactions, and friction that follows "
                           "them, grow without bound"
                         : ""),
      beside ? "give the friction itself, change the lengths so that "
               "the change point is not met, or end the motion before"
             : "look for forces or lengths of a wrong order of size");
}

/// A motion that would take hours is refused with what it is stuck at.
void DynamicRun::require_few(const numerics::StepCounts& counts) const {
  constexpr long kMost = 20'000'000;
  if (counts.evaluations < kMost) return;
  throw Error(
      "K008", "mechanism",
      fmt::format("{} evaluations in {} steps by {} have only reached "
                  "t = {:.9g} s of {:.9g} s",
                  counts.evaluations, counts.steps, integrator_.method(),
                  integrator_.t(), settings_.duration),
      "ask for a shorter motion or a looser tolerance, soften what is "
      "stiff, or try another `integrator`");
}

}  // namespace clevis::mechanism
