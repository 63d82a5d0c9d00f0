#include "elasticity/multigrid/large_part.h"

#include <algorithm>
#include <array>
#include <vector>

#include "elasticity/direct/memory_forecast.h"

namespace clevis::elasticity {

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

double cell_aspect(const Discretization<3>& discretization) {
  const auto n = static_cast<Eigen::Index>(discretization.geometry_degree);
  const std::array<Eigen::Index, 3> stride{n, n * (n + 1),
                                           n * (n + 1) * (n + 1)};
  std::vector<double> ratios;
  for (const auto& points : discretization.cell_points) {
    double longest = 0.0;
    double shortest = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto a = stride[(d + 1) % 3];
      const auto b = stride[(d + 2) % 3];
      double length = 0.0;
      for (const auto at : {Eigen::Index{0}, a, b, a + b}) {
        length += 0.25 * (points.col(at + stride[d]) - points.col(at)).norm();
      }
      longest = d == 0 ? length : std::max(longest, length);
      shortest = d == 0 ? length : std::min(shortest, length);
    }
    ratios.push_back(longest / shortest);
  }
  if (ratios.empty()) return 1.0;
  const auto at = static_cast<std::ptrdiff_t>(
      0.95 * static_cast<double>(ratios.size() - 1));
  std::nth_element(ratios.begin(), ratios.begin() + at, ratios.end());
  return ratios[static_cast<std::size_t>(at)];
}

}  // namespace clevis::elasticity
