#pragma once

#include <string>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// Nodal forces with which the ground holds the seats of a part, one column per
/// direction that it holds: of unit size, spread over the seat's group as a
/// linear traction. Their products with displacements are the seats' mean
/// motions along these directions. In a plane those that act in it.
/// @return dofs × directions; none: the part is free.
/// @throws Error see surface_loads.
template <int dim>
Eigen::MatrixXd ground_hold(const Discretization<dim>& discretization,
                            const loads::LoadHistory& history,
                            const std::string& part_name);

}  // namespace clevis::elasticity
