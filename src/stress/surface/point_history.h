#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {

/// Stress and displacement of some lattice points at some instants.
struct PointHistory {
  Eigen::MatrixXd von_mises;  ///< points × instants [Pa]
  /// points · dim × instants, component after component [m].
  Eigen::MatrixXd displacement;
};

/// @param points  of the lattice of `subdivisions`, those of a cell together.
/// @param instants  of the basis.
template <int dim>
PointHistory point_history(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions,
                           const std::vector<FieldPoint>& points,
                           const std::vector<int>& instants);

}  // namespace clevis::stress
