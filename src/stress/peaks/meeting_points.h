#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/solid/neighbourhood.h"
#include "part/material.h"

namespace clevis::stress {

/// Lattice points of some cells; those that coincide have one number.
struct MeetingPoints {
  std::vector<int> cells;
  Eigen::MatrixXi number;  ///< lattice points × cells
  int count{};
};

template <int dim>
MeetingPoints meeting_points(
    const elasticity::Discretization<dim>& discretization,
    std::vector<int> cells, int subdivisions);

/// Of each number what the cells that meet there say of a quantity.
struct MeetingValues {
  Eigen::VectorXd mean, low, high;
};

/// @param values  lattice points × cells, as in MeetingPoints::number.
/// @return in the units of the values.
MeetingValues meeting_values(const MeetingPoints& points,
                             const Eigen::MatrixXd& values);

/// Von Mises of a field on the lattice of its cells [Pa], points × cells: the
/// mean of the cells that meet at a point, and what they differ by.
struct JoinedStress {
  Eigen::MatrixXd mean, jump;
};
template <int dim>
JoinedStress joined_stress(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions);

}  // namespace clevis::stress
