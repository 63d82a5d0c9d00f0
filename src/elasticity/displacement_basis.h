#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/discretization.h"
#include "elasticity/large_part.h"
#include "elasticity/self_checks.h"
#include "loads/load_history.h"
#include "mesh/part_mesh.h"
#include "part/material.h"
#include "part/part_definition.h"

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
  SolveChecks checks;
  SolveSeconds seconds;
};

/// One linear elastic problem: mesh, material, loads, supports, degree.
template <int dim>
struct ElasticProblem {
  const mesh::PartMesh<dim>& mesh;
  const part::Material& material;
  const loads::LoadHistory& history;
  /// Components held at zero; empty: a free part in balance, held at
  /// determinate components.
  std::map<std::string, std::array<bool, 3>> fixed;
  std::string name;  ///< of the part, for messages
  LinearSolver solver = LinearSolver::kAuto;
  part::Foundations foundations = {};
};

/// One factorisation, the load history compressed to its basis, one block
/// solve; large parts iteratively without a matrix (see large_part.h).
/// @param degree  of the displacement, 1…4 (simplices 1…2).
/// @throws Error F001, F002, F003 if a self-check is breached, F004, M003,
///   L002.
template <int dim>
DisplacementBasis<dim> solve(const ElasticProblem<dim>& problem, int degree);

}  // namespace clevis::elasticity
