#pragma once

#include "elasticity/fe_space/reference_cell.h"

namespace clevis::elasticity {

/// Lagrange basis of any degree on the triangle or tetrahedron
/// (mesh/simplex_basis.h), for displacement and geometry alike, at points in
/// reference coordinates.
template <int dim>
Tabulation tabulate_simplex(int degree, const ReferencePoints<dim>& points);

/// Rule of positive weights on the simplex, exact to total degree 2n − 1.
template <int dim>
Quadrature<dim> gauss_simplex(int n);

/// Rule on a face (deal.II's numbering), see FaceQuadrature.
template <int dim>
FaceQuadrature<dim> face_gauss_simplex(int face, int n);

/// Equidistant lattice in reference coordinates, first coordinate fastest.
template <int dim>
ReferencePoints<dim> lattice_simplex(int subdivisions);

}  // namespace clevis::elasticity
