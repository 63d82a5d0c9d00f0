#pragma once

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// Rise of a quantity from its largest value at a lattice point of a cell to
/// its maximum between the points, by the quadratic polynomial that fits the
/// points around best: the less of it the more that misses the nearest of
/// them, and nothing from a third of the rise on, unless parabolas along the
/// lines of a tensor cell's lattice tell of one. The error is of third order in
/// the lattice's spacing, that of the largest value itself of second.
/// @param subdivisions  of elasticity::lattice.
/// @param values  at the lattice points.
/// @param counting  1 at the points that count, 0 at the others.
/// @param at  the point of the largest value.
/// @return in the unit of the values; 0 where too few points count.
template <int dim>
double rise_between_points(mesh::CellShape shape, int subdivisions,
                           const Eigen::VectorXd& values,
                           const Eigen::VectorXd& counting, Eigen::Index at);

}  // namespace clevis::stress
