#include "elasticity/assembly/gradient_products.h"

#include <algorithm>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/fe_space/tabulation.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int kLowestByDirections = 3;  // below, the dense product is as fast

/// The points of a rule's line in a direction.
/// @param stride  points of the directions before it.
template <int dim>
VectorXd points_along(const ReferencePoints<dim>& points, int direction,
                      Index stride) {
  VectorXd line(0);
  for (Index q = 0; q < points.cols(); q += stride) {
    const double x = points(direction, q);
    if (line.size() > 0 && x <= line[line.size() - 1]) break;
    line.conservativeResize(line.size() + 1);
    line[line.size() - 1] = x;
  }
  return line;
}

}  // namespace

template <int dim>
GradientIntegrator<dim>::GradientIntegrator(
    const Discretization<dim>& discretization, const Quadrature<dim>& rule)
    : displacement_(tabulate_displacement<dim>(
          discretization.shape, discretization.displacement_degree(),
          rule.points)) {
  const Degree degree = discretization.displacement_degree();
  is_by_directions_ =
      dim == 3 && discretization.shape == mesh::CellShape::kTensor &&
      std::min(degree.plane, degree.thickness) >= kLowestByDirections;
  if (is_by_directions_) {
    set_up_directions(discretization, rule);
    return;
  }
  const Index n = displacement_.values.cols();
  products_.row_.setLinSpaced(n, 0, n - 1);
  products_.column_ = n * products_.row_;
}

template <int dim>
void GradientIntegrator<dim>::set_up_directions(
    const Discretization<dim>& discretization, const Quadrature<dim>& rule) {
  const Degree degree = discretization.displacement_degree();
  const auto nodes =
      displacement_support_points<dim>(discretization.shape, degree);
  products_.row_.setZero(nodes.cols());
  products_.column_.setZero(nodes.cols());
  Index points_before = 1, pairs_before = 1;
  for (int d = 0; d < dim; ++d) {
    const VectorXd along =
        mesh::gauss_lobatto(d == dim - 1 ? degree.thickness : degree.plane);
    const auto basis =
        mesh::lagrange(along, points_along(rule.points, d, points_before));
    const auto at = static_cast<std::size_t>(d);
    const Index n = along.size();
    for (Index f = 0; f < nodes.cols(); ++f) {
      Index digit = 0;
      (along.array() - nodes(d, f)).abs().minCoeff(&digit);
      products_.row_[f] += pairs_before * digit;
      products_.column_[f] += pairs_before * n * digit;
    }
    points_before *= basis.value.rows();
    pairs_before *= n * n;
    for (const int left : {0, 1}) {
      for (const int right : {0, 1}) {
        const MatrixXd& first = left == 1 ? basis.slope : basis.value;
        const MatrixXd& second = right == 1 ? basis.slope : basis.value;
        MatrixXd& pairs = lines_[at][static_cast<std::size_t>(left)]
                                [static_cast<std::size_t>(right)];
        pairs.resize(first.rows(), n * n);
        for (Index j = 0; j < n; ++j) {
          for (Index i = 0; i < n; ++i) {
            pairs.col(i + n * j) = first.col(i).cwiseProduct(second.col(j));
          }
        }
      }
    }
  }
  const Line& last = lines_.back();
  const Index rows = last[0][0].rows();
  last_line_.resize(4 * rows, last[0][0].cols());
  for (std::size_t type = 0; type < 4; ++type) {
    last_line_.middleRows(static_cast<Index>(type) * rows, rows) =
        last[type / 2][type % 2];
  }
}

template <int dim>
void GradientIntegrator<dim>::by_points(const CellGeometry<dim>& cell,
                                        const VectorXd& weights) {
  const auto gradients = physical_gradients(cell, displacement_);
  for (std::size_t b = 0; b < dim; ++b) {
    const MatrixXd weighted = weights.asDiagonal() * gradients[b];
    for (std::size_t a = 0; a <= b; ++a) {
      products_.values_[a][b] =
          transposed_product(gradients[a], weighted).reshaped();
    }
  }
}

/// Σ_q D_rs(q) ∂_r N_i ∂_s N_j over reference directions r and s, where D_rs is
/// the weight times ∂ξ_r/∂x_a ∂ξ_s/∂x_b: N is a product of functions of one
/// direction each, so the points of the first are summed first.
template <int dim>
void GradientIntegrator<dim>::by_directions(const CellGeometry<dim>& cell,
                                            const VectorXd& weights) {
  if constexpr (dim == 3) {
    const Index q0 = lines_[0][0][0].rows(), pairs0 = lines_[0][0][0].cols();
    const Index q1 = lines_[1][0][0].rows(), pairs1 = lines_[1][0][0].cols();
    const Index q2 = lines_[2][0][0].rows();
    MatrixXd factor(q0, q1 * q2);
    MatrixXd summed(pairs0 * pairs1, 4 * q2);  // type of the last, its point
    for (std::size_t b = 0; b < dim; ++b) {
      for (std::size_t a = 0; a <= b; ++a) {
        summed.setZero();
        for (std::size_t r = 0; r < dim; ++r) {
          for (std::size_t s = 0; s < dim; ++s) {
            for (Index q = 0; q < factor.size(); ++q) {
              const auto& slope =
                  cell.inverse_jacobian[static_cast<std::size_t>(q)];
              factor.data()[q] =
                  weights[q] *
                  slope(static_cast<Index>(r), static_cast<Index>(a)) *
                  slope(static_cast<Index>(s), static_cast<Index>(b));
            }
            const MatrixXd first =
                transposed_product(lines_[0][r == 0][s == 0], factor);
            const MatrixXd& second = lines_[1][r == 1][s == 1];
            const Index type = 2 * (r == 2) + (s == 2);
            for (Index q = 0; q < q2; ++q) {
              summed.col(type * q2 + q) +=
                  product(first.middleCols(q * q1, q1), second).reshaped();
            }
          }
        }
        products_.values_[a][b] = product(summed, last_line_).reshaped();
      }
    }
  }
}

template <int dim>
const GradientProducts<dim>& GradientIntegrator<dim>::integrate(
    const CellGeometry<dim>& cell, const VectorXd& weights) {
  is_by_directions_ ? by_directions(cell, weights) : by_points(cell, weights);
  return products_;
}

template class GradientIntegrator<2>;
template class GradientIntegrator<3>;

}  // namespace clevis::elasticity
