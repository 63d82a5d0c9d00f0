#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/change_points/singular_start.h"
#include "mechanism/constraints/continuation.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/definition/motion.h"
#include "mechanism/driven_motion/drive_path.h"
#include "mechanism/forces/force_model.h"
#include "mechanism/reactions/equilibrium.h"

namespace clevis::mechanism {

/// A motion that the drives fix: all that does not change from instant to
/// instant. Times are in seconds [s].
class DrivenMotion {
 public:
  DrivenMotion(const MechanismDefinition& definition,
               const SimulationSettings& settings)
      : definition_(definition),
        frame_(definition),
        system_(frame_, definition.drives,
                frame_.planar ? Motions::kInPlane : Motions::kSpatial,
                ConstraintSystem::Drives::kAll),
        joints_(frame_, {}, system_.motions(), ConstraintSystem::Drives::kNone),
        tolerance_(settings.tolerance * frame_.length),
        forces_(definition, frame_),
        path_(definition, frame_, forces_.counts_turns()),
        continuation_(system_, tolerance_),
        equilibrium_(definition, frame_, system_) {}

  /// @param times  increasing, from 0.
  Motion run_at(const std::vector<double>& times,
                const SimulationSettings& settings) const;
  /// Likewise through positions that were found before, which are not followed
  /// again.
  Motion run_through(const std::vector<double>& times,
                     const std::vector<Configuration>& positions,
                     const SimulationSettings& settings) const;

  /// A configuration that the motion passes, and when [s].
  struct Moment {
    Moment(ClosedConfiguration configuration, double time)
        : at(std::move(configuration)), t(time) {}
    ClosedConfiguration at;
    double t{};
  };
  /// The first regular moment; what precedes it goes to `motion`.
  /// @throws Error K005 if there is none and must be one, K007, K010.
  Moment first(const SimulationSettings& settings, Motion& motion) const;
  /// From a regular moment to t.
  /// @param singular  a time after `last` at which J has no full rank.
  void advance(Moment& last, std::optional<double>& singular, double t,
               AtSingularity policy, Motion& motion) const;
  /// To a time nearby, before or after.
  ClosedConfiguration follow(const Moment& from, double t) const;
  /// A moment of a configuration that was passed before.
  Moment moment(const Configuration& x, double t) const {
    return {continuation_.close(x, drive_positions(definition_, t)), t};
  }
  Instant instant(const ClosedConfiguration& at, double t) const;
  /// Evaluates the force elements alone.
  void sense(const Moment& moment) const;
  /// As of the last instant() or sense().
  const ForceModel& forces() const { return forces_; }
  /// Modes that the state of the last sense() suggests.
  std::vector<int> chosen_modes() const;
  /// Angles [rad] and rates [rad/s] of the elements' lines of the last
  /// instant() or sense(): from there turns are counted.
  std::vector<double> line_angles() const;
  void set_line_angles(const std::vector<double>& lines, double t) const;
  double length() const { return frame_.length; }  ///< of the links' order [m]

 private:
  ClosedConfiguration start() const;
  void require_agreement(const ClosedConfiguration& at) const;
  [[noreturn]] void refuse_change_point(const ClosedConfiguration& at,
                                        double t) const;
  /// Velocities and accelerations of M by slot.
  struct Rates {
    std::vector<Twist> twists, accelerations;
  };
  Rates rates(const ClosedConfiguration& at, double t) const;
  /// Positions, drives and rates of an instant; no forces.
  Instant kinematics(const ClosedConfiguration& at, double t,
                     const Rates& rates) const;
  /// Wrenches of the force elements by slot; `result` keeps their states.
  std::vector<Twist> elements(const ClosedConfiguration& at, const Rates& rates,
                              Instant& result) const;
  [[noreturn]] void stop(const Moment& from, Continuation::Reached reached,
                         double t) const;
  double dead_end(const Continuation::Reached& reached,
                  Eigen::VectorXd& targets) const;

  Moment leave(const SingularStart& start, double duration) const;

  Eigen::VectorXd drive_rows(const Eigen::VectorXd& values) const;
  std::optional<Rates> branch_rates(const BranchPoint& point,
                                    const Eigen::VectorXd& along,
                                    double t) const;
  std::optional<Instant> on_branch(const Configuration& x,
                                   const Eigen::VectorXd& along,
                                   double t) const;
  std::optional<Instant> change_point(const Moment& before, double t) const;
  std::optional<double> singular_between(const Moment& from, const Moment& to,
                                         int& halvings) const;
  Moment edge(Moment regular, double singular) const;
  void note_change_points(const Moment& from, const Moment& to,
                          AtSingularity policy, Motion& motion) const;
  void settle(const Moment& last, double singular, const Moment* next,
              AtSingularity policy, Motion& motion) const;

  const MechanismDefinition& definition_;
  SolvingFrame frame_;
  ConstraintSystem system_;
  ConstraintSystem joints_;  ///< without drives
  double tolerance_;
  mutable ForceModel forces_;  // keeps modes between instants
  DrivePath path_;
  Continuation continuation_;
  Equilibrium equilibrium_;
};

}  // namespace clevis::mechanism
