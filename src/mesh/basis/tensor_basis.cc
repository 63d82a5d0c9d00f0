#include "mesh/basis/tensor_basis.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// P_n(x) and P_{n-1}(x) on [-1, 1].
std::pair<double, double> legendre(int n, double x) {
  double before = 1.0, value = x;
  if (n == 0) return {1.0, 0.0};
  for (int k = 2; k <= n; ++k) {
    before =
        std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
  }
  return {value, before};
}

double legendre_slope(int n, double x) {
  const auto [value, before] = legendre(n, x);
  return n * (x * value - before) / (x * x - 1.0);
}

}  // namespace

Quadrature gauss(int n) {
  Quadrature rule{VectorXd(n), VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int newton = 0; newton < 10; ++newton) {
      x -= legendre(n, x).first / legendre_slope(n, x);
    }
    const double slope = legendre_slope(n, x);
    rule.points[i] = 0.5 * (1.0 + x);
    rule.weights[i] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

VectorXd gauss_lobatto(int degree) {
  VectorXd points(degree + 1);
  points[0] = 0.0;
  points[degree] = 1.0;
  // The inner points are the zeros of P'; Newton with
  // (1 - x²) P'' = 2 x P' - n (n + 1) P.
  for (int i = 1; i < degree; ++i) {
    double x = -std::cos(std::numbers::pi * i / degree);
    for (int newton = 0; newton < 10; ++newton) {
      const double slope = legendre_slope(degree, x);
      const double curvature =
          (2.0 * x * slope -
           degree * (degree + 1) * legendre(degree, x).first) /
          (1.0 - x * x);
      x -= slope / curvature;
    }
    points[i] = 0.5 * (1.0 + x);
  }
  return points;
}

LagrangeBasis lagrange(const VectorXd& nodes, const VectorXd& points) {
  const Index n = nodes.size();
  LagrangeBasis basis{MatrixXd(points.size(), n), MatrixXd(points.size(), n)};
  for (Index p = 0; p < points.size(); ++p) {
    for (Index i = 0; i < n; ++i) {
      double value = 1.0, slope = 0.0;
      for (Index j = 0; j < n; ++j) {
        if (j == i) continue;
        const double scale = 1.0 / (nodes[i] - nodes[j]);
        const double factor = (points[p] - nodes[j]) * scale;
        slope = slope * factor + value * scale;
        value *= factor;
      }
      basis.value(p, i) = value;
      basis.slope(p, i) = slope;
    }
  }
  return basis;
}

namespace {

/// Weighted sums of `in` rows of `left` numbers; `count` neighbours of a row at
/// a time, so that they stay in registers.
template <int count>
inline __attribute__((always_inline)) void combine(
    const double* __restrict from, const double* __restrict weights, Index in,
    Index left, Index stride, double* __restrict to) {
  double sum[count] = {};
  for (Index i = 0; i < in; ++i) {
    const double weight = weights[i * stride];
    for (int l = 0; l < count; ++l) sum[l] += weight * from[i * left + l];
  }
  for (int l = 0; l < count; ++l) to[l] = sum[l];
}

}  // namespace

// Without fused products: masses and the motion that follows from them have the
// same bits on every processor.
__attribute__((target_clones("avx2", "default"))) void contract(
    const double* source, const MatrixXd& basis, double* target, Index left,
    Index right) {
  const Index in = basis.cols(), out = basis.rows();
  const double* weights = basis.data();
  for (Index r = 0; r < right; ++r, source += left * in) {
    for (Index o = 0; o < out; ++o, target += left) {
      Index l = 0;
      for (; l + 16 <= left; l += 16) {
        combine<16>(source + l, weights + o, in, left, out, target + l);
      }
      for (; l + 4 <= left; l += 4) {
        combine<4>(source + l, weights + o, in, left, out, target + l);
      }
      switch (left - l) {
        case 3:
          combine<3>(source + l, weights + o, in, left, out, target + l);
          break;
        case 2:
          combine<2>(source + l, weights + o, in, left, out, target + l);
          break;
        case 1:
          combine<1>(source + l, weights + o, in, left, out, target + l);
          break;
        default:
          break;
      }
    }
  }
}

template <int dim>
Eigen::Matrix<double, dim, Eigen::Dynamic> interpolate(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& nodal,
    const std::array<const MatrixXd*, dim>& along) {
  MatrixXd now = nodal;
  Index left = dim;  // components and the directions already done
  for (const MatrixXd* basis : along) {
    const Index in = basis->cols(), out = basis->rows();
    const Index right = now.size() / (left * in);
    MatrixXd next(left * out, right);
    contract(now.data(), *basis, next.data(), left, right);
    now = std::move(next);
    left *= out;
  }
  return Eigen::Map<const Eigen::Matrix<double, dim, Eigen::Dynamic>>(
      now.data(), dim, now.size() / dim);
}

std::array<Eigen::Matrix3Xd, 3> tangents_at_nodes(
    const Eigen::Matrix3Xd& cell_points, const MatrixXd& slope) {
  std::array<Eigen::Matrix3Xd, 3> tangents;
  const Index n = slope.rows();
  Index left = 3;
  for (auto& tangent : tangents) {
    tangent.resize(3, cell_points.cols());
    contract(cell_points.data(), slope, tangent.data(), left,
             cell_points.size() / (left * n));
    left *= n;
  }
  return tangents;
}

template <int dim>
MappedGrid<dim> map_grid(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& cell_points,
    const std::array<const LagrangeBasis*, dim>& along) {
  MappedGrid<dim> grid;
  std::array<const MatrixXd*, dim> bases{};
  for (unsigned d = 0; d < dim; ++d) bases[d] = &along[d]->value;
  grid.points = interpolate<dim>(cell_points, bases);
  for (unsigned d = 0; d < dim; ++d) {
    bases[d] = &along[d]->slope;
    grid.tangents[d] = interpolate<dim>(cell_points, bases);
    bases[d] = &along[d]->value;
  }
  return grid;
}

template Eigen::Matrix2Xd interpolate<2>(const Eigen::Matrix2Xd&,
                                         const std::array<const MatrixXd*, 2>&);
template Eigen::Matrix3Xd interpolate<3>(const Eigen::Matrix3Xd&,
                                         const std::array<const MatrixXd*, 3>&);
template MappedGrid<2> map_grid<2>(const Eigen::Matrix2Xd&,
                                   const std::array<const LagrangeBasis*, 2>&);
template MappedGrid<3> map_grid<3>(const Eigen::Matrix3Xd&,
                                   const std::array<const LagrangeBasis*, 3>&);

}  // namespace clevis::mesh
