#include "stress/displacement/finite_motion.h"

#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/fe_space/tabulation.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// ∂u_a/∂x_d at the middle of a cell: row dim a + d, a column per basis column.
template <int dim>
MatrixXd middle_slopes(const elasticity::DisplacementBasis<dim>& basis,
                       const elasticity::Tabulation& displacement,
                       const elasticity::CellInterpolation<dim>& geometry,
                       std::size_t cell) {
  const auto& discretization = basis.discretization;
  const auto at = elasticity::cell_geometry<dim>(
      discretization.cell_points[cell], geometry);
  const auto gradients = elasticity::physical_gradients<dim>(at, displacement);
  const auto& nodes = discretization.cell_nodes[cell];
  MatrixXd slopes = MatrixXd::Zero(dim * dim, basis.columns.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (Index a = 0; a < dim; ++a) {
      for (Index d = 0; d < dim; ++d) {
        slopes.row(dim * a + d) +=
            gradients[static_cast<std::size_t>(d)](0, static_cast<Index>(i)) *
            basis.columns.row(dim * nodes[i] + a);
      }
    }
  }
  return slopes;
}

/// Half the curl of a displacement gradient, its length.
template <int dim>
double rotation_of(const Eigen::Matrix<double, dim, dim>& slope) {
  const auto skew = slope - slope.transpose();
  return 0.5 * skew.norm() / std::sqrt(2.0);
}

template <int dim>
double principal_strain(const Eigen::Matrix<double, dim, dim>& slope) {
  const Eigen::Matrix<double, dim, dim> strain =
      0.5 * (slope + slope.transpose());
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, dim, dim>> solver;
  solver.computeDirect(strain, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

template <int dim>
FieldMotion field_motion(const elasticity::DisplacementBasis<dim>& basis) {
  const auto& discretization = basis.discretization;
  const auto points = elasticity::lattice<dim>(discretization.shape, 1);
  const elasticity::ReferencePoints<dim> middle = points.rowwise().mean();
  const auto displacement = elasticity::tabulate_displacement<dim>(
      discretization.shape, discretization.displacement_degree(), middle);
  const elasticity::CellInterpolation<dim> geometry(
      discretization.shape, discretization.mapping_degree(), middle);
  using Slope = Eigen::Matrix<double, dim, dim, Eigen::RowMajor>;
  FieldMotion motion;
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const MatrixXd slopes = elasticity::product(
        middle_slopes<dim>(basis, displacement, geometry, c),
        basis.coefficients);
    for (Index i = 0; i < slopes.cols(); ++i) {
      const Eigen::Matrix<double, dim, dim> slope =
          Eigen::Map<const Slope>(slopes.col(i).data());
      const double rotation = rotation_of<dim>(slope);
      if (rotation > motion.rotation) {
        motion.rotation = rotation;
        motion.rotation_instant = static_cast<int>(i);
      }
      // No principal strain is larger than the norm of all components.
      if (slope.norm() <= motion.strain) continue;
      const double strain = principal_strain<dim>(slope);
      if (strain <= motion.strain) continue;
      motion.strain = strain;
      motion.strain_instant = static_cast<int>(i);
    }
  }
  return motion;
}

template FieldMotion field_motion<2>(const elasticity::DisplacementBasis<2>&);
template FieldMotion field_motion<3>(const elasticity::DisplacementBasis<3>&);

}  // namespace clevis::stress
