#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/nodal_loads/surface_loads.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// Components of a seat's wrench, force before moment, that act on a part of
/// this dimension.
template <int dim>
inline constexpr auto kActing = [] {
  if constexpr (dim == 2) {
    return std::array<Eigen::Index, 3>{0, 1, 5};
  } else {
    return std::array<Eigen::Index, 6>{0, 1, 2, 3, 4, 5};
  }
}();

/// Unit wrenches of seats as nodal forces, dofs × acting components, seat by
/// seat, each spread over its seat's group, or the zone that its counterpart
/// touches, as a linear traction: their products with displacements are the
/// seats' mean motions about their points [1], [1/m].
/// @param zones  one per seat; empty: all of each group.
/// @throws Error see surface_loads.
template <int dim>
Eigen::MatrixXd seat_means(const Discretization<dim>& discretization,
                           std::vector<loads::Seat> seats,
                           const std::vector<loads::ContactZone>& zones,
                           const std::string& part_name);

/// The same of one seat, on the nodes of its group alone.
/// @param zones  of the seat, one; empty: all of the group.
template <int dim>
SurfaceLoads seat_mean(const Discretization<dim>& discretization,
                       loads::Seat seat,
                       const std::vector<loads::ContactZone>& zones,
                       const std::string& part_name);

/// The same of a slide's.
template <int dim>
SurfaceLoads seat_mean(const SlideWall<dim>& wall, loads::Seat seat,
                       const std::vector<loads::ContactZone>& zones);

}  // namespace clevis::elasticity
