#pragma once

#include <Eigen/Core>

#include "mechanism/change_points/singular_position.h"
#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Velocities that a scene prescribes at the start: rows · velocities = rates,
/// turns × length [m/s].
/// Drives, then initial rates of joints, then components of bodies.
struct WantedRates {
  Eigen::MatrixXd rows;  ///< by row the motion per unknown
  Eigen::VectorXd rates;
  bool at_rest() const { return rates.isZero(0.0); }
};
WantedRates wanted_rates(const MechanismDefinition& definition,
                         const SolvingFrame& frame, Motions motions,
                         const Configuration& x);

/// A start where the joints' Jacobian has lost rank, on the one branch that
/// the rates single out.
struct SingularStart {
  BranchPoint point;
  Eigen::VectorXd velocities;  ///< unknowns
};
/// @param joints   system without drives.
/// @param x        closed.
/// @param freedom  of the mechanism beside such places.
/// @throws Error K007 if no branch moves by these rates; K010 if several do,
///   with the joints whose rates would decide.
SingularStart singular_start(const MechanismDefinition& definition,
                             const SolvingFrame& frame,
                             const ConstraintSystem& joints,
                             const Configuration& x, const WantedRates& wanted,
                             int freedom);

/// @throws Error K007, always. @param violation  [m/s].
[[noreturn]] void refuse_rates(const MechanismDefinition& definition,
                               double violation);

}  // namespace clevis::mechanism
