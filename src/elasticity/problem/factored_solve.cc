#include "elasticity/problem/factored_solve.h"

#include <memory>
#include <optional>

#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "elasticity/direct/memory_forecast.h"
#include "elasticity/problem/single_precision.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

template <typename Real>
Inverse factored(const MatrixRows& matrix, const FrontTree& tree,
                 const FactorOptions& options, const std::string& name) {
  const auto factor = std::make_shared<const FrontalFactor<Real>>(
      matrix, tree, name, options.threads);
  return [factor](const MatrixXd& b) {
    return factor->solve(b);
  };
}

/// @return nothing where seven digits don't do.
std::optional<FactoredSolution> solve_in_single(
    const MatrixRows& matrix, const FrontTree& tree,
    const StiffnessAction::Product& multiply, const MatrixXd& right_hand_sides,
    const FactorOptions& options, const std::string& name) {
  FactoredSolution result;
  Stopwatch watch;
  try {
    result.inverse = factored<float>(matrix, tree, options, name);
  } catch (const Error&) {
    return std::nullopt;  // not positive definite in floats
  }
  result.factor_seconds = watch.lap();
  auto columns =
      solve_by_single_precision(multiply, result.inverse, right_hand_sides);
  if (!columns) return std::nullopt;
  result.columns = *std::move(columns);
  result.solve_seconds = watch.lap();
  return result;
}

}  // namespace

Precision cheaper_precision(double flops, double bytes, double columns) {
  constexpr double kLarge = 3e10;           // below, time is not in the flops
  constexpr double kFlopsPerSecond = 3e10;  // of doubles, one core of 2020
  constexpr double kBytesPerSecond = 8e9;   // through which the factor goes
  constexpr double kSteps = 6.0;            // of conjugate gradients
  constexpr double kAtATime = 8.0;          // columns that go with it
  const double saved = 0.5 * flops / kFlopsPerSecond;
  const double spent =
      kSteps * bytes / kBytesPerSecond * (1.0 + columns / kAtATime);
  return flops >= kLarge && spent < saved ? Precision::kSingle
                                          : Precision::kDouble;
}

FactoredSolution solve_by_factor(const MatrixRows& matrix,
                                 const FrontTree& tree,
                                 const StiffnessAction::Product& multiply,
                                 const MatrixXd& right_hand_sides,
                                 const FactorOptions& options,
                                 const std::string& name) {
  Stopwatch watch;
  if (options.precision == Precision::kSingle) {
    auto result = solve_in_single(matrix, tree, multiply, right_hand_sides,
                                  options, name);
    if (result) return *std::move(result);
    const double bytes =
        sizeof(double) * static_cast<double>(tree.factor_entries());
    require_memory(bytes, matrix.rows(), usable_memory(), name);
  }
  FactoredSolution result;
  result.inverse = factored<double>(matrix, tree, options, name);
  result.factor_seconds = watch.lap();
  result.columns = result.inverse(right_hand_sides);
  result.solve_seconds = watch.lap();
  return result;
}

}  // namespace clevis::elasticity
