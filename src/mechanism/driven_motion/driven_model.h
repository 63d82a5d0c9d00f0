#pragma once

#include <utility>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/constraints/continuation.h"
#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/time_limit.h"
#include "mechanism/reactions/equilibrium.h"

namespace clevis::mechanism {

/// A configuration that a driven motion passes, and when.
struct DrivenMoment {
  DrivenMoment(ClosedConfiguration configuration, double time)
      : at(std::move(configuration)), t(time) {}
  ClosedConfiguration at;
  double t{};  ///< [s]
};

/// A mechanism whose motion the drives fix, its equations, and the positions
/// that it passes: all that does not change from instant to instant. Times [s].
struct DrivenModel {
  /// @param given  outlives this.
  DrivenModel(const MechanismDefinition& given,
              const SimulationSettings& settings);

  /// The configuration at t, on the branch of a regular moment nearby, before
  /// or after. @throws Error K004 where no position continues the motion, K013
  ///   where the processor's time for it is used up.
  ClosedConfiguration follow(const DrivenMoment& from, double t) const;
  /// A moment of a configuration that was passed before. @throws Error K013.
  DrivenMoment moment(const Configuration& x, double t) const;
  /// Values by drive [m] or [rad], or their rates, scaled as the rows are.
  Eigen::VectorXd drive_rows(const Eigen::VectorXd& values) const;
  /// @throws Error K005, always: J loses rank at `at`, at t.
  [[noreturn]] void refuse_change_point(const ClosedConfiguration& at,
                                        double t) const;

  const MechanismDefinition& definition;
  SolvingFrame frame;
  ConstraintSystem system;
  ConstraintSystem joints;  ///< without drives
  double tolerance;         ///< of closure [m]
  Continuation continuation;
  Equilibrium equilibrium;

 private:
  /// @param t  of the position that is asked for.
  void require_in_time(double t) const;
  [[noreturn]] void stop(const DrivenMoment& from,
                         const Continuation::Reached& reached, double t) const;
  Eigen::VectorXd dead_end(const Continuation::Reached& reached,
                           const Eigen::VectorXd& targets) const;

  double duration_;         ///< [s]
  TimeLimit limit_;         ///< from the construction on
  mutable long asked_ = 0;  ///< positions: a count, of no effect on results
};

}  // namespace clevis::mechanism
