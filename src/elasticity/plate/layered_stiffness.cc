#include "elasticity/plate/layered_stiffness.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/node_pairs.h"
#include "elasticity/assembly/stiffness.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

void scatter(const std::vector<int>& ids,
             const std::array<MatrixXd, PlaneIntegrals::kKinds>& cell,
             PlaneIntegrals& result) {
  std::vector<std::size_t> sorted(ids.size());
  std::iota(sorted.begin(), sorted.end(), 0U);
  std::ranges::sort(sorted, {}, [&](std::size_t i) {
    return ids[i];
  });
  for (std::size_t r = 0; r < sorted.size(); ++r) {
    const auto i = static_cast<Index>(sorted[r]);
    auto at = static_cast<std::size_t>(
        result.row_start[static_cast<std::size_t>(ids[sorted[r]])]);
    for (std::size_t s = r; s < sorted.size(); ++s) {
      const auto j = static_cast<Index>(sorted[s]);
      while (result.column[at] != ids[sorted[s]]) ++at;
      for (std::size_t k = 0; k < cell.size(); ++k) {
        result.value[at][k] += cell[k](i, j);
      }
    }
  }
}

/// Coefficients of the nine plane integrals in each entry of a pair's block.
using BlockRecipe = std::vector<std::vector<std::pair<std::size_t, double>>>;

BlockRecipe block_recipe(const part::Material& material, Parity parity,
                         int terms, double thickness) {
  const auto [lambda, mu] = lame_constants<3>(material);
  const ThicknessIntegrals z = thickness_integrals(parity, terms, thickness);
  const int n = 3 * terms;
  BlockRecipe recipe(static_cast<std::size_t>(n * n));
  const auto add = [&](int row, int column, PlaneIntegrals::Kind kind,
                       double factor) {
    if (factor == 0.0) return;
    recipe[static_cast<std::size_t>(row * n + column)].emplace_back(kind,
                                                                    factor);
  };
  using Kind = PlaneIntegrals::Kind;
  // The plane's derivatives of row and column function, by direction.
  constexpr Kind kSlopes[2][2] = {{Kind::kXX, Kind::kXY},
                                  {Kind::kYX, Kind::kYY}};
  constexpr Kind kSlopeValue[2] = {Kind::kX0, Kind::kY0};
  constexpr Kind kValueSlope[2] = {Kind::k0X, Kind::k0Y};
  for (int a = 0; a < terms; ++a) {
    for (int b = 0; b < terms; ++b) {
      const int za = 2 * terms + a;
      const int zb = 2 * terms + b;
      for (int c = 0; c < 2; ++c) {
        const int row = c * terms + a;
        for (int d = 0; d < 2; ++d) {
          const int column = d * terms + b;
          add(row, column, kSlopes[c][d], lambda * z.in_plane(a, b));
          add(row, column, kSlopes[d][c], mu * z.in_plane(a, b));
          if (c != d) continue;
          add(row, column, Kind::kXX, mu * z.in_plane(a, b));
          add(row, column, Kind::kYY, mu * z.in_plane(a, b));
          add(row, column, Kind::k00, mu * z.in_plane_slopes(a, b));
        }
        add(row, zb, kSlopeValue[c], lambda * z.value_by_slope(a, b));
        add(row, zb, kValueSlope[c], mu * z.slope_by_value(a, b));
        add(za, c * terms + b, kValueSlope[c], lambda * z.value_by_slope(b, a));
        add(za, c * terms + b, kSlopeValue[c], mu * z.slope_by_value(b, a));
        add(za, zb, kSlopes[c][c], mu * z.transverse(a, b));
      }
      add(za, zb, Kind::k00, (lambda + 2.0 * mu) * z.transverse_slopes(a, b));
    }
  }
  return recipe;
}

}  // namespace

PlaneIntegrals plane_integrals(const Discretization<2>& plane,
                               const std::string& place) {
  PlaneIntegrals result;
  NodePairs pairs = node_pairs(plane.cell_nodes, plane.nodes);
  result.row_start = std::move(pairs.row_start);
  result.column = std::move(pairs.column);
  result.value.resize(result.column.size());
  const auto rule = stiffness_quadrature(plane);
  const auto displacement = tabulate_displacement<2>(
      plane.shape, plane.displacement_degree(), rule.points);
  const CellInterpolation<2> geometry(plane.shape, plane.mapping_degree(),
                                      rule.points);
  for (std::size_t c = 0; c < plane.cell_nodes.size(); ++c) {
    const auto at = cell_geometry<2>(plane.cell_points[c], geometry);
    require_positive(at.determinant, c, plane.geometry_degree, place);
    const auto slopes = physical_gradients(at, displacement);
    const Eigen::VectorXd weights = rule.weights.cwiseProduct(at.determinant);
    std::array<MatrixXd, PlaneIntegrals::kKinds> cell;
    const auto integral = [&](const MatrixXd& a, const MatrixXd& b) {
      return transposed_product(a, weights.asDiagonal() * b);
    };
    cell[PlaneIntegrals::kXX] = integral(slopes[0], slopes[0]);
    cell[PlaneIntegrals::kXY] = integral(slopes[0], slopes[1]);
    cell[PlaneIntegrals::kYX] = cell[PlaneIntegrals::kXY].transpose();
    cell[PlaneIntegrals::kYY] = integral(slopes[1], slopes[1]);
    cell[PlaneIntegrals::kX0] = integral(slopes[0], displacement.values);
    cell[PlaneIntegrals::kY0] = integral(slopes[1], displacement.values);
    cell[PlaneIntegrals::k0X] = cell[PlaneIntegrals::kX0].transpose();
    cell[PlaneIntegrals::k0Y] = cell[PlaneIntegrals::kY0].transpose();
    cell[PlaneIntegrals::k00] =
        integral(displacement.values, displacement.values);
    scatter(plane.cell_nodes[c], cell, result);
  }
  return result;
}

UpperTriangle layered_stiffness(const PlaneIntegrals& plane,
                                const part::Material& material, Parity parity,
                                int terms, double thickness) {
  const auto recipe = block_recipe(material, parity, terms, thickness);
  const int n = 3 * terms;
  UpperTriangle upper;
  upper.row_start.push_back(0);
  const std::size_t block =
      static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  upper.column.reserve(plane.column.size() * block);
  upper.value.reserve(plane.column.size() * block);
  for (int i = 0; i < plane.nodes(); ++i) {
    const auto begin = plane.row_start[static_cast<std::size_t>(i)];
    const auto end = plane.row_start[static_cast<std::size_t>(i) + 1];
    for (int row = 0; row < n; ++row) {
      for (int pair = begin; pair < end; ++pair) {
        const auto& values = plane.value[static_cast<std::size_t>(pair)];
        const int j = plane.column[static_cast<std::size_t>(pair)];
        for (int column = i == j ? row : 0; column < n; ++column) {
          const auto& sum = recipe[static_cast<std::size_t>(row * n + column)];
          if (sum.empty()) continue;
          double value = 0.0;
          for (const auto& [kind, factor] : sum) value += factor * values[kind];
          upper.column.push_back(n * j + column);
          upper.value.push_back(value);
        }
      }
      upper.row_start.push_back(entry_number(upper.column.size()));
    }
  }
  return upper;
}

}  // namespace clevis::elasticity
