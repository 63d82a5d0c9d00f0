#pragma once

#include "elasticity/problem/displacement_basis.h"

namespace clevis::stress {

/// How far a displacement field is from an infinitesimal one.
struct FieldMotion {
  double rotation{};       ///< largest |½ curl u| of a cell's middle [rad]
  int rotation_instant{};  ///< when
  double strain{};  ///< largest principal strain there, by its amount [1]
  int strain_instant{};
};

/// Over all cells and instants. The rotation refers to what the basis'
/// displacements do: the supports, or the pins (remove_rigid_motion). Middles
/// of cells: of bending, not of the nearness of a corner.
template <int dim>
FieldMotion field_motion(const elasticity::DisplacementBasis<dim>& basis);

}  // namespace clevis::stress
