#pragma once

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"

namespace clevis::stress {

/// Largest displacement of the part relative to its pins.
struct Deflection {
  double value{};                                ///< [m]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in L [m]
  int instant{};
  Eigen::VectorXd of_instant;  ///< largest of each [m]
};

/// The largest nodal displacement over all instants.
template <int dim>
Deflection largest_deflection(const elasticity::DisplacementBasis<dim>& basis);

/// The same of a plate's surface by plane stress: it moves across the plate as
/// well, by half its thickness times the strain there, of the cells at a node
/// their mean.
Deflection largest_deflection_of_plate(
    const elasticity::DisplacementBasis<2>& basis,
    const part::Material& material);

/// The value alone, where instants are thousands: nodes are looked at in all of
/// them that come near the largest in every `stride`-th [m].
template <int dim>
double largest_deflection_of_many(
    const elasticity::DisplacementBasis<dim>& basis, int stride);

}  // namespace clevis::stress
