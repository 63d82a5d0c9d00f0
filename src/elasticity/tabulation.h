#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/part_mesh.h"

namespace clevis::elasticity {

/// Points of a reference cell ([0, 1]^dim or the unit simplex), one a column.
template <int dim>
using ReferencePoints = Eigen::Matrix<double, dim, Eigen::Dynamic>;

/// Scalar shape functions and their reference gradients at given points.
struct Tabulation {
  Eigen::MatrixXd values;                  ///< points × functions
  std::vector<Eigen::MatrixXd> gradients;  ///< per direction, like values
};

/// Polynomial degree of a cell's basis. Tensor cells may have their own in the
/// last direction of dim = 3, that of a plate's thickness.
struct Degree {
  int plane{};
  int thickness{};
  Degree(int isotropic) : plane(isotropic), thickness(isotropic) {}  // NOLINT
  Degree(int in_plane, int through_thickness)
      : plane(in_plane), thickness(through_thickness) {}
  int highest() const { return plane > thickness ? plane : thickness; }
};

/// Displacement basis: Lagrange on Gauss–Lobatto points in the numbering of
/// deal.II's FE_Q, lexicographic where the degrees differ; of simplices that
/// of mesh::simplex_lattice.
template <int dim>
Tabulation tabulate_displacement(mesh::CellShape shape, Degree degree,
                                 const ReferencePoints<dim>& points);

/// Geometry basis of PartMesh::cell_points: Lagrange on Gauss–Lobatto points,
/// lexicographic; of simplices through mesh::simplex_nodes.
template <int dim>
Tabulation tabulate_geometry(mesh::CellShape shape, Degree degree,
                             const ReferencePoints<dim>& points);

/// Points at which the displacement basis is nodal, in its numbering.
template <int dim>
ReferencePoints<dim> displacement_support_points(mesh::CellShape shape,
                                                 Degree degree);

/// Points of tabulate_geometry's basis, in its order.
template <int dim>
ReferencePoints<dim> geometry_support_points(mesh::CellShape shape,
                                             Degree degree);

/// Quadrature on the reference cell.
template <int dim>
struct Quadrature {
  ReferencePoints<dim> points;
  Eigen::VectorXd weights;
};

/// Gauss rule exact for degree 2n − 1 in each direction (n.thickness points
/// in the last of dim = 3); of simplices exact to total degree 2n − 1.
template <int dim>
Quadrature<dim> gauss(mesh::CellShape shape, Degree n);

/// Gauss rule on a face of the reference cell, points in cell coordinates and
/// weights of the reference face; `outward` its outward normal scaled so that
/// the physical area vector is weight * det(J) J^-T outward.
template <int dim>
struct FaceQuadrature {
  ReferencePoints<dim> points;
  Eigen::VectorXd weights;
  Eigen::Matrix<double, dim, 1> outward;
};
template <int dim>
FaceQuadrature<dim> face_gauss(mesh::CellShape shape, int face, Degree n);

/// Equidistant lattice with `subdivisions` + 1 points a direction,
/// lexicographic (tensor cells), or the lattice of the simplex.
template <int dim>
ReferencePoints<dim> lattice(mesh::CellShape shape, int subdivisions);

}  // namespace clevis::elasticity
