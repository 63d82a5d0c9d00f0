#pragma once

#include <array>
#include <string>
#include <vector>

#include "elasticity/algebra/sparse_cholesky.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/plate/thickness_terms.h"
#include "part/material.h"

namespace clevis::elasticity {

/// ∫ over the mid-plane of products of the plane's functions and their
/// derivatives, for pairs of nodes i <= j: everything of the plane that a
/// stiffness matrix with any number of thickness terms is made of.
struct PlaneIntegrals {
  enum Kind { kXX, kXY, kYX, kYY, kX0, kY0, k0X, k0Y, k00, kKinds };
  std::vector<int> row_start;  ///< nodes + 1
  std::vector<int> column;     ///< sorted within a row
  std::vector<std::array<double, kKinds>> value;
  int nodes() const { return static_cast<int>(row_start.size()) - 1; }
};

/// @param place  of an error, e.g. "part DCE".
/// @throws Error M005 if the mapping of a cell is not positive at a point.
PlaneIntegrals plane_integrals(const Discretization<2>& plane,
                               const std::string& place);

/// Stiffness matrix of a plate in 3-D elasticity with `terms` Legendre
/// polynomials of each field, unknowns as in ThicknessReduction: sums of
/// Kronecker products of plane and thickness integrals.
UpperTriangle layered_stiffness(const PlaneIntegrals& plane,
                                const part::Material& material, Parity parity,
                                int terms, double thickness);

}  // namespace clevis::elasticity
