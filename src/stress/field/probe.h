#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"

namespace clevis::stress {

/// Where a point lies: every cell that holds it (several on an edge or at a
/// corner) with its reference coordinates there.
template <int dim>
using Location = std::vector<std::pair<int, Eigen::Matrix<double, dim, 1>>>;

/// Finds a point of L [m] by Newton's method on the cells whose bounds hold it;
/// to 1e-6 of a cell. One that no cell holds stands in the nearest, on its
/// surface: curved walls bulge out of cells. Empty if it is outside the part.
/// For dim = 2 the point may lie anywhere in the thickness.
/// @param bulge  how far a wall may stand off, over a cell's size [1].
template <int dim>
Location<dim> locate(const elasticity::Discretization<dim>& discretization,
                     const Eigen::Vector3d& at, double bulge);

/// A quantity at a point; SI.
struct PointValue {
  double value{};  ///< mean over the cells that hold the point
  double jump{};   ///< what these cells differ by
};

/// A quantity at a point at one instant.
/// @param quantity  von_mises, stress_xx … stress_xz, displacement_x … z.
/// @pre `location` is not empty, the quantity is one of these.
template <int dim>
PointValue probe(const elasticity::DisplacementBasis<dim>& basis,
                 const part::Material& material, const Location<dim>& location,
                 const std::string& quantity, int instant);

}  // namespace clevis::stress
