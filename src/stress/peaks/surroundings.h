#pragma once

#include "elasticity/fe_space/tabulation.h"
#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// A point of a cell, first, and its neighbours at a spacing along and across
/// all directions, as far as they lie in the cell; in reference coordinates.
template <int dim>
elasticity::ReferencePoints<dim> surroundings(
    mesh::CellShape shape, const Eigen::Matrix<double, dim, 1>& centre,
    double spacing);

}  // namespace clevis::stress
