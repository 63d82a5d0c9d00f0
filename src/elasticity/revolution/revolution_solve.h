#pragma once

#include <array>
#include <map>
#include <string>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/dof_limit.h"
#include "loads/history/load_history.h"
#include "mesh/derived/revolution.h"
#include "part/material.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// A linear elastic solid of revolution under any loads.
struct RevolutionProblem {
  const mesh::Revolution& solid;
  const part::Material& material;
  const loads::LoadHistory& history;
  /// Components of L held at zero; empty: a free part in balance.
  part::Supports fixed;
  std::string name;  ///< of the part, for messages
  DofLimit max_dofs = std::nullopt;
  DofListener tell_dofs = {};
};

struct RevolutionSolution {
  DisplacementBasis<3> basis;  ///< on the revolved discretisation
  int terms{};                 ///< of the Fourier series that are solved
  /// Contribution of the upper half of the orders to basis.columns (no rows if
  /// nothing is left out of the series): its stress at a point is about what
  /// the orders left out still bring there.
  Eigen::MatrixXd upper_half;
};

/// Highest order that is solved with a degree of the displacement: it rises
/// with the degree, so that a p-sequence shows the error of both.
int highest_order(int degree);

/// Whether supports hold every term for itself, and hold the part: `fixed` is
/// empty, or the components across the axis are held together and the part
/// cannot move.
bool supports_fit(const mesh::Revolution& solid, const part::Supports& fixed);

/// One factorisation for each order that something loads.
/// @param degree  of the displacement in the meridian, 1…4.
/// @pre supports_fit.
/// @throws Error F002, F003 if a self-check is breached, F007, M003, M005,
/// L002.
RevolutionSolution solve_revolution(const RevolutionProblem& problem,
                                    int degree);

}  // namespace clevis::elasticity
