#pragma once

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/engine.h"
#include "elasticity/problem/self_checks.h"

namespace clevis::elasticity {

/// Wall-clock seconds of the stages.
struct SolveSeconds {
  double assemble{}, factor{}, solve{};
};

/// Displacements of a part for its whole load history: u(t_i) = U c_i.
template <int dim>
struct DisplacementBasis {
  Discretization<dim> discretization;
  int equations{};          ///< unknowns solved for; 0: discretization.dofs()
  Eigen::MatrixXd columns;  ///< U, dofs × rank [m]
  Eigen::MatrixXd coefficients;   ///< rank × instants
  Eigen::VectorXd strain_energy;  ///< per instant [J]
  /// Even or odd about the mid-plane of a layer, so that von Mises is even.
  bool is_mirrored = false;
  EngineChoice engine;
  SolveChecks checks;
  SolveSeconds seconds;
};

}  // namespace clevis::elasticity
