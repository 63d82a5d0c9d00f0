#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/discretization.h"
#include "loads/load_history.h"

namespace clevis::elasticity {

/// Consistent nodal loads of every instant, dofs × instants [N].
///
/// Seats: bearing or linear traction at the quadrature points of the group,
/// plus the correction that makes the discrete resultant the wrench to
/// round-off. Surface loads likewise. Body: −ρ (a + α×p + ω×(ω×p)). For
/// dim = 2 all is integrated through the thickness.
/// @param density [kg/m³].
/// @throws Error M003 if the mesh lacks a group, L002 if a bearing seat's
///   group is no cylinder.
template <int dim>
Eigen::MatrixXd assemble_loads(const Discretization<dim>& discretization,
                               const loads::LoadHistory& history,
                               double density, const std::string& part_name);

/// Balances the discrete loads of a free part: the interpolated geometry and
/// its quadrature have not quite the exact mass, which leaves a residual that a
/// rigid acceleration of the discrete mass takes up (inertia relief).
/// @param modes  rigid modes at the nodes, dofs × modes.
/// @return the largest residual before, over the loads' size [1].
template <int dim>
double balance_loads(const Discretization<dim>& discretization, double density,
                     const Eigen::MatrixXd& modes, Eigen::MatrixXd& history);

}  // namespace clevis::elasticity
