#pragma once

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"

namespace clevis::mechanism {

/// Reactions of rigid links on joints that give way, c(x) = −C λ: bounded also
/// where those of rigid joints are not.
struct CompliantBalance {
  Eigen::VectorXd lambda;  ///< scaled, by row [N]
  double deflection{};     ///< largest displacement from the closed joints [m]
  bool found = false;
};

/// Minimises ½ cᵀ C⁻¹ c + fᵀ u (−f the loads) over displacements u from the
/// closed configuration x, so that Jᵀ λ = f at the displaced one: the geometric
/// stiffness of the loaded joints carries what J cannot. By Newton's method,
/// damped where the energy is not convex. The loads keep their directions;
/// drives are ten times as stiff as joints by default.
/// @param f     as of ConstraintSystem::wrench_vector [N].
/// @param held  columns: directions in which nothing is displaced, those of a
///   motion that forces decide; f has no part along them.
/// Source: docs/theory.md, "Change points".
CompliantBalance compliant_balance(const SolvingFrame& frame,
                                   const ConstraintSystem& system,
                                   const Configuration& x,
                                   const Eigen::VectorXd& f,
                                   const Eigen::MatrixXd& held = {});

}  // namespace clevis::mechanism
