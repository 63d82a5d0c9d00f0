#pragma once

#include <Eigen/Core>

#include "mesh/basis/simplex_basis.h"

namespace clevis::mesh {

/// Points and positive weights, whose sum is the simplex's measure.
template <int dim>
struct SimplexQuadrature {
  SimplexPoints<dim> points;
  Eigen::VectorXd weights;
};

/// Gauss–Jacobi rules of n points along each direction of the collapsed
/// square or cube ([Stroud1971], conical products); exact to total degree 2n
/// − 1.
template <int dim>
SimplexQuadrature<dim> simplex_gauss(int n);

}  // namespace clevis::mesh
