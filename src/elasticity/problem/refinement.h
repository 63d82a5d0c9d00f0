#pragma once

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

/// Improves U by K⁻¹ (F − K U) with the factor at hand until the correction
/// is round-off, at most a few times.
/// @param stiffness  more exact than the factor.
/// @param loads      F [N].
/// @param columns    U, dofs × columns [m].
void refine(const StiffnessAction& stiffness, const FrontalCholesky& factor,
            const EquationNumbers& numbers, const LoadBasis& loads,
            Eigen::MatrixXd& columns);

}  // namespace clevis::elasticity
