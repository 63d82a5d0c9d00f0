#pragma once

#include <functional>

#include <Eigen/Core>

#include "elasticity/assembly/equations.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/nodal_loads/load_basis.h"
#include "elasticity/problem/self_checks.h"
#include "part/material.h"

namespace clevis::elasticity {

/// K U as ∫ Bᵀ D (B U) dV: strains first, so that its round-off is that of
/// the strains and not of K's entries, which hardly know the bending of a
/// slender part (docs/theory.md, "Round-off").
/// @param columns  U, dofs × columns [m].
/// @return dofs × columns [N].
template <int dim>
Eigen::MatrixXd forces_by_strain(const Discretization<dim>& discretization,
                                 const part::Material& material,
                                 const Eigen::MatrixXd& columns);

/// B -> about K⁻¹ B of the equations, by the factor at hand.
using Inverse = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// @param factor  outlives it.
template <typename Real>
Inverse inverse_by(const FrontalFactor<Real>& factor) {
  return [&factor](const Eigen::MatrixXd& b) {
    return factor.solve(b);
  };
}

/// Improves U by K⁻¹ (F − K U) until the correction is round-off, at most a few
/// times.
/// @param stiffness  more exact than the inverse.
/// @param loads      F [N].
/// @param columns    U, dofs × columns [m].
void refine(const StiffnessAction& stiffness, const Inverse& inverse,
            const EquationNumbers& numbers, const LoadBasis& loads,
            Eigen::MatrixXd& columns);

}  // namespace clevis::elasticity
