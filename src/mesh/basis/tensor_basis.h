#pragma once

#include <array>

#include <Eigen/Core>

namespace clevis::mesh {

/// Points and weights on [0, 1].
struct Quadrature {
  Eigen::VectorXd points, weights;
};

/// Gauss–Legendre rule of n points, exact to degree 2n − 1.
Quadrature gauss(int n);

/// The degree + 1 Gauss–Lobatto points on [0, 1], ascending.
Eigen::VectorXd gauss_lobatto(int degree);

/// Lagrange polynomials through `nodes` at `points`: (points × nodes).
struct LagrangeBasis {
  Eigen::MatrixXd value, slope;
};
/// @param nodes, points  on the reference interval [0, 1].
LagrangeBasis lagrange(const Eigen::VectorXd& nodes,
                       const Eigen::VectorXd& points);

/// One direction of a tensor, from nodes to points: for each of `right` slices,
/// target (left × points) = source (left × nodes) basisᵀ, all column-major.
/// @param basis  points × nodes.
void contract(const double* source, const Eigen::MatrixXd& basis,
              double* target, Eigen::Index left, Eigen::Index right);

/// Σ_ij… A0(p0,i) A1(p1,j)… X(:, i,j,…): a tensor-product polynomial with the
/// nodal values X (first index fastest) at a tensor grid of points, by one
/// small matrix product per direction.
template <int dim>
Eigen::Matrix<double, dim, Eigen::Dynamic> interpolate(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& nodal,
    const std::array<const Eigen::MatrixXd*, dim>& along);

/// A mapping x(ξ) and its Jacobian columns ∂x/∂ξ_d at a grid of points [m];
/// one column per point.
template <int dim>
struct MappedGrid {
  Eigen::Matrix<double, dim, Eigen::Dynamic> points;
  std::array<Eigen::Matrix<double, dim, Eigen::Dynamic>, dim> tangents;

  Eigen::Matrix<double, dim, dim> jacobian(Eigen::Index q) const {
    Eigen::Matrix<double, dim, dim> J;
    for (int d = 0; d < dim; ++d) J.col(d) = tangents[unsigned(d)].col(q);
    return J;
  }
};

/// ∂x/∂ξ_d at the nodes of a hexahedron's mapping, for each d [m].
/// @param slope  of the 1-D basis at its own nodes.
std::array<Eigen::Matrix3Xd, 3> tangents_at_nodes(
    const Eigen::Matrix3Xd& cell_points, const Eigen::MatrixXd& slope);

/// Evaluates a cell's mapping; one 1-D basis per direction.
/// @param cell_points  dim × nodes [m].
template <int dim>
MappedGrid<dim> map_grid(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& cell_points,
    const std::array<const LagrangeBasis*, dim>& along);

}  // namespace clevis::mesh
