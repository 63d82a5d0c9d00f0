#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

/// Result of the search for a configuration that closes all rows.
struct Assembled {
  Configuration x;
  bool closed = false;
  Eigen::VectorXd residual;
};

/// Configuration nearest to `guess` that satisfies the rows of the system:
/// damped Gauss–Newton with steps of minimal norm and limited length.
/// @param targets    coordinates of the drives [m] or [rad].
/// @param tolerance  of the residual [m].
/// @param rank_threshold  SolvingFrame::rank_threshold().
Assembled assemble(const ConstraintSystem& system, Configuration guess,
                   const Eigen::VectorXd& targets, double tolerance,
                   double rank_threshold = numerics::kRankThreshold);

/// Rows that stay open.
struct OpenJoints {
  std::string text;  ///< "B by 12.3 mm, cylinder (drive) by 4 mm"
  /// Joints that are open along their axes alone.
  std::vector<std::string> along_axes;
  double tolerance{};  ///< [m]
};
/// @param residual, tolerance  turns × length [m].
OpenJoints open_joints(const MechanismDefinition& definition,
                       const ConstraintSystem& system,
                       const Eigen::VectorXd& residual, double tolerance);

}  // namespace clevis::mechanism
