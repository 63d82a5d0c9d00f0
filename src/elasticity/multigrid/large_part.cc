#include "elasticity/multigrid/large_part.h"

#include <algorithm>
#include <array>
#include <vector>

#include "elasticity/direct/memory_forecast.h"

namespace clevis::elasticity {
namespace {

/// Where a corner stands among the points of a tensor cell.
Eigen::Index corner_column(unsigned corner, Eigen::Index degree, unsigned dim) {
  Eigen::Index column = 0;
  Eigen::Index stride = degree;
  for (unsigned d = 0; d < dim; ++d) {
    if ((corner >> d & 1U) != 0) column += stride;
    stride *= degree + 1;
  }
  return column;
}

}  // namespace

bool suits_multigrid(const Discretization<3>& discretization,
                     const part::Material& material) {
  constexpr double kLargestRatio = 0.45;
  return discretization.shape == mesh::CellShape::kTensor &&
         !discretization.is_layer && discretization.degree >= 2 &&
         discretization.degree <= 4 &&
         discretization.thickness_degree == discretization.degree &&
         material.poissons_ratio <= kLargestRatio;
}

// tests/benchmarks/direct_solve and large_parts.
double factor_seconds(double flops) {
  constexpr double kFlopsPerSecond = 3e10;
  return flops / kFlopsPerSecond;
}

double multigrid_seconds(double dofs, double columns) {
  constexpr double kSecondsPerColumn = 0.7e-6;  // and degree of freedom
  constexpr double kSecondsOfSetup = 4e-6;      // per degree of freedom
  return dofs * (columns * kSecondsPerColumn + kSecondsOfSetup);
}

bool prefers_multigrid(const Discretization<3>& discretization,
                       const part::Material& material, const DirectCost& direct,
                       double columns, double memory) {
  constexpr double kClearly = 2.0;
  constexpr double kAnisotropic = 4.0;  // above, too many iterations
  if (!suits_multigrid(discretization, material)) return false;
  if (!holds(direct.bytes, memory)) return true;
  return factor_seconds(direct.flops) >
             kClearly * multigrid_seconds(discretization.dofs(), columns) &&
         cell_aspect(discretization) < kAnisotropic;
}

template <int dim>
double cell_aspect(const Discretization<dim>& discretization) {
  const auto n = static_cast<Eigen::Index>(discretization.geometry_degree);
  std::vector<double> ratios;
  for (const auto& points : discretization.cell_points) {
    std::array<double, dim> lengths{};  // summed over parallel sides
    for (unsigned corner = 0; corner < 1U << dim; ++corner) {
      const auto from = points.col(corner_column(corner, n, dim));
      for (unsigned d = 0; d < dim; ++d) {
        const unsigned other = corner | 1U << d;
        if (other == corner) continue;
        lengths[d] += (points.col(corner_column(other, n, dim)) - from).norm();
      }
    }
    const auto [shortest, longest] = std::ranges::minmax(lengths);
    ratios.push_back(longest / shortest);
  }
  if (ratios.empty()) return 1.0;
  const auto at = static_cast<std::ptrdiff_t>(
      0.95 * static_cast<double>(ratios.size() - 1));
  std::nth_element(ratios.begin(), ratios.begin() + at, ratios.end());
  return ratios[static_cast<std::size_t>(at)];
}

template double cell_aspect<2>(const Discretization<2>&);
template double cell_aspect<3>(const Discretization<3>&);

}  // namespace clevis::elasticity
