#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/continuation.h"
#include "mechanism/equilibrium.h"
#include "mechanism/force_model.h"
#include "mechanism/motion.h"

namespace clevis::mechanism {

/// Coordinates of the drives at time t [s].
Eigen::VectorXd drive_positions(const MechanismDefinition& definition,
                                double t);

/// A motion that the drives fix: all that does not change from instant to
/// instant.
class DrivenMotion {
 public:
  DrivenMotion(const MechanismDefinition& definition,
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
  void require_agreement(const ClosedConfiguration& at) const;
  void require_regular(const ClosedConfiguration& at, double t) const;
  [[noreturn]] void refuse_change_point(const ClosedConfiguration& at,
                                        double t) const;
  [[noreturn]] void stop(const Continuation::Reached& reached, double t) const;
  std::string drives_at(const Eigen::VectorXd& targets) const;
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
  Instant instant(const ClosedConfiguration& at, double t) const;
  ClosedConfiguration follow(const ClosedConfiguration& from, double t) const;
  struct Moment {
    Moment(ClosedConfiguration configuration, double time)
        : at(std::move(configuration)), t(time) {
      if (at.factor.full_column_rank()) weakest = at.factor.weakest();
    }
    ClosedConfiguration at;
    double t{};
    JacobianFactor::Weakest weakest{};
  };
  std::optional<Instant> change_point(const Moment& from, double t,
                                      double t_step) const;
  std::optional<double> singular_between(const Moment& from, const Moment& to,
                                         int& halvings) const;
  std::array<Moment, 2> singular_interval(const Moment& from, double t_hit,
                                          const Moment& to) const;
  void note_change_points(const Moment& from, const Moment& to,
                          AtSingularity policy, Motion& motion) const;

  const MechanismDefinition& definition_;
  SolvingFrame frame_;
  ConstraintSystem system_;
  double tolerance_;
  mutable ForceModel forces_;  // keeps modes between instants
  Continuation continuation_;
  Equilibrium equilibrium_;
};

}  // namespace clevis::mechanism
