#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/foundation.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::calculix {

/// Degrees of freedom that must be held: the components of the problem's
/// `fixed`, and where these and the beds leave rigid modes on which no load
/// does work, determinate components at vertices; sorted.
/// @param modes  rigid modes at the nodes, dofs × 6.
/// @param loads  dofs × instants [N].
/// @throws Error F001 if a load drives a mode that is free.
std::vector<int> determinate_dofs(
    const elasticity::Discretization<3>& discretization,
    const elasticity::ElasticProblem<3>& problem,
    const elasticity::FoundationStiffness<3>& beds,
    const Eigen::MatrixXd& modes, const Eigen::MatrixXd& loads);

}  // namespace clevis::calculix
