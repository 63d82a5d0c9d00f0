#include "mechanism/simulate.h"

#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/assembly.h"
#include "mechanism/body_motion.h"
#include "mechanism/closed_joints.h"
#include "mechanism/continuation.h"
#include "mechanism/drive_law.h"
#include "mechanism/dynamic_motion.h"
#include "mechanism/equilibrium.h"
#include "mechanism/force_model.h"
#include "mechanism/mobility.h"
#include "mechanism/power_balance.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

void require_mass(const MechanismDefinition& definition) {
  for (const BodyDefinition& body : definition.bodies) {
    if (body.mass_properties.mass > 0.0) continue;
    throw Error("K006", body.place,
                fmt::format("body {} has a mass of {} kg", body.name,
                            body.mass_properties.mass),
                "give the body a mass, center_of_mass and inertia, or a part");
  }
}

VectorXd positions(const MechanismDefinition& definition, double t) {
  VectorXd q(static_cast<Eigen::Index>(definition.drives.size()));
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] = drive_target(definition.drives[static_cast<std::size_t>(i)], t)
               .position;
  }
  return q;
}

/// One run: all that does not change from instant to instant.
class Simulation {
 public:
  Simulation(const MechanismDefinition& definition,
             const SimulationSettings& settings)
      : definition_(definition),
        frame_(definition),
        system_(frame_, definition.drives,
                frame_.planar ? Motions::kInPlane : Motions::kSpatial,
                ConstraintSystem::Drives::kAll),
        tolerance_(settings.tolerance * frame_.length),
        forces_(definition, frame_),
        continuation_(system_, tolerance_),
        equilibrium_(definition, frame_, system_) {}

  Motion run(const SimulationSettings& settings) const;

 private:
  ClosedConfiguration start() const;
  void require_regular(const ClosedConfiguration& at, double t) const;
  [[noreturn]] void stop(const Continuation::Reached& reached, double t) const;
  std::string drives_at(const VectorXd& targets) const;
  Instant instant(const ClosedConfiguration& at, double t) const;

  const MechanismDefinition& definition_;
  SolvingFrame frame_;
  ConstraintSystem system_;
  double tolerance_;
  mutable ForceModel forces_;  // keeps modes between instants
  Continuation continuation_;
  Equilibrium equilibrium_;
};

ClosedConfiguration Simulation::start() const {
  require_driven(definition_,
                 mobility(frame_, system_,
                          closed_joints(definition_, frame_, tolerance_)));
  const VectorXd targets = positions(definition_, 0.0);
  const Assembled assembled =
      assemble(system_, frame_.placement, targets, tolerance_);
  if (!assembled.closed) {
    refuse_open(
        open_joints(definition_, system_, assembled.residual, tolerance_),
        "all joints with the drives at their start");
  }
  return continuation_.close(assembled.x, targets);
}

std::string Simulation::drives_at(const VectorXd& targets) const {
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

void Simulation::require_regular(const ClosedConfiguration& at,
                                 double t) const {
  if (at.factor.full_column_rank()) return;
  throw Error("K005", "mechanism",
              fmt::format("at t = {:.6g} s ({}) the constraint Jacobian has "
                          "rank {} instead of {}",
                          t, drives_at(at.targets), at.factor.rank(),
                          system_.columns()),
              "choose instants, lengths or a range of the drive that avoid "
              "this position: the branch is undetermined there and rigid "
              "reactions have no bound");
}

void Simulation::stop(const Continuation::Reached& reached, double t) const {
  throw Error("K004", "mechanism",
              fmt::format("before t = {:.6g} s the mechanism stops at {}: "
                          "beyond it no position continues the motion",
                          t, drives_at(reached.at.targets)),
              "reduce the range of the drive, or correct the lengths");
}

Instant Simulation::instant(const ClosedConfiguration& at, double t) const {
  const auto n_drives = static_cast<Eigen::Index>(definition_.drives.size());
  VectorXd rate = VectorXd::Zero(system_.rows());
  VectorXd second = VectorXd::Zero(system_.rows());
  Instant result;
  result.t = t;
  result.drives.resize(definition_.drives.size());
  for (Eigen::Index i = 0; i < n_drives; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Index row = system_.joint_rows() + i;
    const double scale =
        system_.scale(system_.row_list()[static_cast<std::size_t>(row)].row);
    const DriveTarget target = drive_target(definition_.drives[k], t);
    rate[row] = scale * target.rate;
    second[row] = scale * target.acceleration;
    result.drives[k].position = target.position;
    result.drives[k].rate = target.rate;
    result.drives[k].acceleration = target.acceleration;
  }
  const std::vector<Twist> twists = system_.twists(at.factor.solve(rate));
  second -= system_.bias(at.placed, twists);
  const std::vector<Twist> accelerations =
      system_.twists(at.factor.solve(second));
  for (std::size_t i = 0; i < definition_.bodies.size(); ++i) {
    result.bodies.push_back(body_motion(frame_, static_cast<BodyIndex>(i),
                                        at.x[i + 1], twists[i + 1],
                                        accelerations[i + 1]));
  }
  forces_.evaluate(t, at.x, twists, nullptr);
  forces_.choose_modes();
  forces_.evaluate(t, at.x, twists, nullptr);
  forces_.accept(t);
  std::vector<Twist> applied(at.x.size());
  forces_.add_to(applied);
  result.elements = forces_.states();
  Equilibrium::Solution forces = equilibrium_.solve(
      at.x, at.placed, at.factor, twists, accelerations, applied);
  put_forces(frame_, system_, at.placed, std::move(forces), result);
  result.closure_error = at.gap;
  return result;
}

Motion Simulation::run(const SimulationSettings& settings) const {
  Motion motion;
  ClosedConfiguration at = start();
  require_regular(at, 0.0);
  const int n = settings.instants;
  motion.instants.reserve(static_cast<std::size_t>(n));
  double t_before = 0.0;
  for (int i = 0; i < n; ++i) {
    const double t = n > 1 ? settings.duration * i / (n - 1) : 0.0;
    if (i > 0) {
      const int sign = at.factor.determinant_sign();
      Continuation::Reached reached =
          continuation_.follow(at, positions(definition_, t));
      if (reached.part < 1.0) stop(reached, t);
      at = std::move(reached.at);
      require_regular(at, t);
      if (at.factor.determinant_sign() != sign) {
        motion.change_points.push_back({t_before, t});
      }
    }
    motion.instants.push_back(instant(at, t));
    t_before = t;
  }
  judge_power_balance(definition_, motion);
  return motion;
}

/// Whether the drives leave freedom, so that forces decide the motion.
bool is_dynamic(const MechanismDefinition& definition,
                const SimulationSettings& settings) {
  if (settings.motion != MotionKind::kAuto) {
    return settings.motion == MotionKind::kDynamic;
  }
  const SolvingFrame frame(definition);
  // bristles have a history of their own
  if (ForceModel(definition, frame).internal_states() > 0) return true;
  const ConstraintSystem system(
      frame, definition.drives,
      frame.planar ? Motions::kInPlane : Motions::kSpatial,
      ConstraintSystem::Drives::kAll);
  const Mobility freedom = mobility(
      frame, system,
      closed_joints(definition, frame, settings.tolerance * frame.length));
  return freedom.with_drives > 0 && freedom.dependent_drives.empty();
}

}  // namespace

Motion simulate(const MechanismDefinition& definition,
                const SimulationSettings& settings) {
  require_mass(definition);
  if (is_dynamic(definition, settings)) {
    return integrate_motion(definition, settings);
  }
  return Simulation(definition, settings).run(settings);
}

}  // namespace clevis::mechanism
