#pragma once

#include <vector>

#include <Eigen/Core>

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

/// Quadrature on the reference cell.
template <int dim>
struct Quadrature {
  ReferencePoints<dim> points;
  Eigen::VectorXd weights;
};

/// Gauss rule on a face of the reference cell, points in cell coordinates and
/// weights of the reference face; `outward` its outward normal scaled so that
/// the physical area vector is weight * det(J) J^-T outward.
template <int dim>
struct FaceQuadrature {
  ReferencePoints<dim> points;
  Eigen::VectorXd weights;
  Eigen::Matrix<double, dim, 1> outward;
};

}  // namespace clevis::elasticity
