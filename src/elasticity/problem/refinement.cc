#include "elasticity/problem/refinement.h"

#include <vector>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/fe_space/tabulation.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Displacements of a cell's nodes, functions × (dim × columns), component
/// after component, less those of its first node: a translation has no strain
/// but costs digits.
template <int dim>
MatrixXd relative_displacements(const std::vector<int>& nodes,
                                const MatrixXd& columns) {
  const Index n = columns.cols();
  MatrixXd result(static_cast<Index>(nodes.size()), dim * n);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (int a = 0; a < dim; ++a) {
      result.row(static_cast<Index>(i)).segment(a * n, n) =
          columns.row(dim * nodes[i] + a) -
          columns.row(dim * nodes.front() + a);
    }
  }
  return result;
}

/// Weighted stress from gradients. Both: row block d, column block a is
/// direction d of component a, points × columns each.
template <int dim>
MatrixXd weighted_stress(const MatrixXd& slopes, const LameConstants<dim>& lame,
                         const Eigen::VectorXd& weights) {
  const Index n = weights.size();
  const Index columns = slopes.cols() / dim;
  const auto slope = [&](int d, int a) {
    return slopes.block(d * n, a * columns, n, columns);
  };
  MatrixXd trace = slope(0, 0);
  for (int d = 1; d < dim; ++d) trace += slope(d, d);
  MatrixXd stress(slopes.rows(), slopes.cols());
  for (int d = 0; d < dim; ++d) {
    for (int a = 0; a < dim; ++a) {
      MatrixXd component = lame.mu * (slope(d, a) + slope(a, d));
      if (a == d) component += lame.lambda * trace;
      stress.block(d * n, a * columns, n, columns) =
          weights.asDiagonal() * component;
    }
  }
  return stress;
}

}  // namespace

template <int dim>
MatrixXd forces_by_strain(const Discretization<dim>& discretization,
                          const part::Material& material,
                          const MatrixXd& columns) {
  const auto lame = lame_constants<dim>(material);
  const auto rule = stiffness_quadrature(discretization);
  const auto displacement = tabulate_displacement<dim>(
      discretization.shape, discretization.displacement_degree(), rule.points);
  const CellInterpolation<dim> geometry(
      discretization.shape, discretization.mapping_degree(), rule.points);
  const Index points = rule.weights.size();
  MatrixXd forces = MatrixXd::Zero(columns.rows(), columns.cols());
  MatrixXd slope(dim * points, displacement.values.cols());
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto at = cell_geometry<dim>(discretization.cell_points[c], geometry);
    const auto gradients = physical_gradients(at, displacement);
    for (int d = 0; d < dim; ++d) {
      slope.middleRows(d * points, points) =
          gradients[static_cast<std::size_t>(d)];
    }
    const auto& nodes = discretization.cell_nodes[c];
    const MatrixXd slopes =
        product(slope, relative_displacements<dim>(nodes, columns));
    const MatrixXd nodal = transposed_product(
        slope, weighted_stress<dim>(slopes, lame,
                                    rule.weights.cwiseProduct(at.determinant) *
                                        discretization.thickness));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (int a = 0; a < dim; ++a) {
        forces.row(dim * nodes[i] + a) +=
            nodal.row(static_cast<Index>(i))
                .segment(a * columns.cols(), columns.cols());
      }
    }
  }
  return forces;
}

void refine(const StiffnessAction& stiffness, const Inverse& inverse,
            const EquationNumbers& numbers, const LoadBasis& loads,
            MatrixXd& columns) {
  constexpr int kSweeps = 5;
  constexpr double kRoundOff = 1e-13;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const MatrixXd rest = loads.columns - stiffness.multiply(columns);
    const MatrixXd correction =
        extend_rows(inverse(restrict_rows(rest, numbers)), numbers);
    columns += correction;
    const Eigen::ArrayXd size = columns.colwise().norm().transpose().array();
    const Eigen::ArrayXd change =
        correction.colwise().norm().transpose().array();
    if ((change <= kRoundOff * size).all()) return;
  }
}

template MatrixXd forces_by_strain<2>(const Discretization<2>&,
                                      const part::Material&, const MatrixXd&);
template MatrixXd forces_by_strain<3>(const Discretization<3>&,
                                      const part::Material&, const MatrixXd&);

}  // namespace clevis::elasticity
