#pragma once

#include <array>
#include <map>
#include <string>

#include <Eigen/Core>

#include "elasticity/problem/dof_limit.h"
#include "elasticity/problem/engine.h"
#include "loads/history/load_history.h"
#include "mesh/cells/part_mesh.h"
#include "part/material.h"
#include "part/part_definition.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// How the equations are solved.
enum class LinearSolver {
  kAuto,      ///< as prefers_multigrid() says
  kDirect,    ///< sparse Cholesky
  kMultigrid  ///< MultigridSolver; hexahedra of degree 2…4 only
};

/// One linear elastic problem: mesh, material, loads, supports, degree.
template <int dim>
struct ElasticProblem {
  const mesh::PartMesh<dim>& mesh;
  const part::Material& material;
  const loads::LoadHistory& history;
  /// Components held at zero; empty: a free part in balance, held at
  /// determinate components.
  part::Supports fixed;
  std::string name;  ///< of the part, for messages
  LinearSolver solver = LinearSolver::kAuto;
  part::Foundations foundations = {};
  Engine engine = Engine::kAuto;  ///< of plane stress and 3-D
  /// The other ranks of this MPI run serve_dealii() while this one solves.
  bool is_shared = false;
  DofLimit max_dofs = std::nullopt;  ///< asked for
  /// Error of each instant's load, over the largest load, that is enough of it;
  /// empty: all are solved as exactly as they can be. The model of revolution
  /// solves them so anyway.
  Eigen::VectorXd admitted_load_error = {};
  DofListener tell_dofs = {};
};

}  // namespace clevis::elasticity
