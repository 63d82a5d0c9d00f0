#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mesh/basis/tensor_basis.h"

namespace clevis::mesh {

/// A lattice point of a simplex: its barycentric coordinates times the degree,
/// that of vertex 0 (the origin of the reference simplex) first.
template <int dim>
using SimplexIndex = std::array<int, dim + 1>;

/// The lattice of a degree, first reference coordinate fastest.
template <int dim>
std::vector<SimplexIndex<dim>> simplex_lattice(int degree);

template <int dim>
using SimplexPoints = Eigen::Matrix<double, dim, Eigen::Dynamic>;

/// Interpolation points of a degree in the order of simplex_lattice:
/// Gauss–Lobatto on the edges, recursively blended inside ([Isaac2020]); the
/// same from every vertex, so that the cells on both sides of a face agree
/// about its points.
template <int dim>
SimplexPoints<dim> simplex_nodes(int degree);

/// Functions at points: (points × functions), and their derivatives along the
/// reference coordinates.
template <int dim>
struct SimplexTable {
  Eigen::MatrixXd value;
  std::array<Eigen::MatrixXd, std::size_t(dim)> slope;
};

/// Bernstein's polynomials n!/α! λ^α, in the order of simplex_lattice: not
/// negative inside, so that coefficients bound a polynomial.
template <int dim>
SimplexTable<dim> bernstein(int degree, const SimplexPoints<dim>& points);

/// Lagrange polynomials through simplex_nodes [1].
/// @param points  in reference coordinates [1], dim × points.
template <int dim>
SimplexTable<dim> simplex_lagrange(int degree,
                                   const SimplexPoints<dim>& points);

/// A simplex's mapping and its Jacobian columns at the points of a table [m].
/// @param cell_points  of the cell, dim × nodes [m].
template <int dim>
MappedGrid<dim> map_simplex(const SimplexPoints<dim>& cell_points,
                            const SimplexTable<dim>& table);

/// Columns from vertex 0 to the others [m] of a cell that is affine to 1e-13 of
/// its size; nothing if it is curved.
/// @param nodes  simplex_nodes of the cell's degree.
template <int dim>
std::optional<Eigen::Matrix<double, dim, dim>> affine_edges(
    const SimplexPoints<dim>& cell_points, const SimplexPoints<dim>& nodes);

/// The n^dim simplices of the lattice of degree n, positively oriented, as
/// positions in simplex_lattice.
template <int dim>
std::vector<std::array<int, dim + 1>> simplex_parts(int n);

/// Vertices of a face of the triangle or tetrahedron, deal.II's numbering.
template <int dim>
const std::array<int, dim>& simplex_face(int face);

/// +1 if the vertices of a tetrahedron's face turn so that their area vector
/// points outward, else −1 [1].
double simplex_face_sense(int face);

/// Points of the lattice that lie on a face, as its vertices span them: the
/// lattice of one dimension less, in its own order.
template <int dim>
std::vector<int> simplex_face_lattice(int degree, int face);

}  // namespace clevis::mesh
