#pragma once

#include "elasticity/fe_space/reference_cell.h"
#include "mesh/cells/part_mesh.h"

namespace clevis::elasticity {

/// Displacement basis: Lagrange on Gauss–Lobatto points in the numbering of
/// deal.II's FE_Q, lexicographic where the degrees differ; of simplices that
/// of mesh::simplex_lattice.
/// @param points  in reference coordinates.
template <int dim>
Tabulation tabulate_displacement(mesh::CellShape shape, Degree degree,
                                 const ReferencePoints<dim>& points);

/// Geometry basis of PartMesh::cell_points: Lagrange on Gauss–Lobatto points,
/// lexicographic; of simplices through mesh::simplex_nodes.
/// @param points  in reference coordinates.
template <int dim>
Tabulation tabulate_geometry(mesh::CellShape shape, Degree degree,
                             const ReferencePoints<dim>& points);

/// Where each function of the displacement basis stands in the basis of
/// tabulate_geometry of the same degree.
template <int dim>
std::vector<int> displacement_places(mesh::CellShape shape, Degree degree);

/// Points at which the displacement basis is nodal, in its numbering; in
/// reference coordinates.
template <int dim>
ReferencePoints<dim> displacement_support_points(mesh::CellShape shape,
                                                 Degree degree);

/// Points of tabulate_geometry's basis, in its order; in reference coordinates.
template <int dim>
ReferencePoints<dim> geometry_support_points(mesh::CellShape shape,
                                             Degree degree);

/// Gauss rule exact for degree 2n − 1 in each direction (n.thickness points
/// in the last of dim = 3); of simplices exact to total degree 2n − 1.
template <int dim>
Quadrature<dim> gauss(mesh::CellShape shape, Degree n);

/// Gauss rule on a face.
template <int dim>
FaceQuadrature<dim> face_gauss(mesh::CellShape shape, int face, Degree n);

/// Equidistant lattice in reference coordinates with `subdivisions` + 1 points
/// a direction, lexicographic (tensor cells), or the lattice of the simplex.
template <int dim>
ReferencePoints<dim> lattice(mesh::CellShape shape, int subdivisions);

}  // namespace clevis::elasticity
