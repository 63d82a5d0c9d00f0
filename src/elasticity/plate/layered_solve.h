#pragma once

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::elasticity {

/// A plate in 3-D elasticity by polynomials of its mid-plane times Legendre
/// polynomials through its thickness, `terms` of the in-plane and as many of
/// the transverse displacement. Loads symmetric about the mid-plane take even
/// in-plane and odd transverse terms, antisymmetric ones the converse; others
/// are split and solved twice. The result is a 3-D field on one layer of
/// hexahedra.
///
/// @param degree  of the displacement in the plane, 1…5.
/// @param terms  2 or more: with one, a bent plate could not thin.
/// @pre the mesh's cells are quads.
/// @throws Error as solve().
DisplacementBasis<3> solve_layered(const ElasticProblem<2>& problem, int degree,
                                   int terms);

}  // namespace clevis::elasticity
