#pragma once

#include <string>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// loads::SeatHold as nodal forces, dofs × columns, each wrench spread over its
/// seat's group, or the zone that its counterpart touches, as a linear
/// traction: their products with displacements are the seats' mean motions. In
/// a plane those that act in it.
/// Where springs swing other bodies by themselves, `bodies` > 0, each column
/// goes on below the equations with as many rows of their motions.
struct NeighbourHold {
  Eigen::MatrixXd held;     ///< [1], independent
  Eigen::MatrixXd weighed;  ///< [√kg], as few as their masses need
  Eigen::MatrixXd sprung;   ///< [√(N/m)], likewise
  Eigen::MatrixXd damped;   ///< [√(N s/m)], likewise
  Eigen::Index bodies = 0;  ///< their motions
};

/// Nothing: the part is free.
/// @throws Error see surface_loads.
template <int dim>
NeighbourHold neighbour_hold(const Discretization<dim>& discretization,
                             const loads::LoadHistory& history,
                             const std::string& part_name);

}  // namespace clevis::elasticity
