#include "assessment/impact/response_scatter.h"

#include <algorithm>
#include <cmath>

namespace clevis::assessment {
namespace {

/// Scatter of a quantity over the variants beyond its linear trend with the
/// mass.
class VariedQuantity {
 public:
  explicit VariedQuantity(double value) { take(0.0, value); }
  void take(double more, double value) {
    more_.push_back(more);
    values_.push_back(value);
  }
  /// Least and largest value without the trend, over the first.
  double low() const { return rest().minCoeff() / values_.front(); }
  double high() const { return rest().maxCoeff() / values_.front(); }
  double width() const { return is_known() ? high() / low() - 1.0 : 0.0; }
  double least(double other) const {
    return is_known() ? std::min(values_.front(), other) * low() : 0.0;
  }
  /// Upper end, half the range higher: seven variants are a small sample.
  double most(double other) const {
    if (!is_known()) return 0.0;
    return std::max(values_.front(), other) * (1.5 * high() - 0.5 * low());
  }

 private:
  bool is_known() const { return values_.front() > 0.0; }
  Eigen::VectorXd rest() const {
    const auto n = static_cast<Eigen::Index>(values_.size());
    const Eigen::Map<const Eigen::VectorXd> x(more_.data(), n);
    const Eigen::Map<const Eigen::VectorXd> y(values_.data(), n);
    return y - x.dot(y) / x.squaredNorm() * x;  // the x are even about zero
  }

  std::vector<double> more_, values_;
};

}  // namespace

template <int dim>
std::optional<ResponseScatter> response_scatter(
    const PartJob& job, const ImpactJob& impact,
    const std::vector<stress::SingularZone>& zones, int degree,
    const StruckRun<dim>& coarse, const StruckRun<dim>& fine,
    StruckFaces<dim>& faces) {
  constexpr double kNoticed = 0.01;
  if (coarse.response.motion().touches < 2) return std::nullopt;
  VariedQuantity stress(coarse.stress), root(coarse.root.value),
      deflection(coarse.deflection.value);
  auto& face = faces.get(job, impact, degree);
  for (const double more : {-0.02, -0.01, -0.005, 0.005, 0.01, 0.02}) {
    ImpactJob other = impact;
    other.strike.mass *= 1.0 + more;
    other.strike.speed /= std::sqrt(1.0 + more);
    const auto basis =
        face.solve(other.strike,
                   strike_options(job, dynamics::Route::kModal, other))
            .basis;
    stress.take(more, judged_stress(basis, job, zones));
    root.take(more, support_peak(basis, job, impact).value);
    deflection.take(more, stress::largest_deflection<dim>(basis).value);
  }
  const double largest =
      std::max({stress.width(), root.width(), deflection.width()});
  if (largest < kNoticed) return std::nullopt;
  return ResponseScatter{
      .stress_low = stress.least(fine.stress),
      .stress_high = stress.most(fine.stress),
      .root_low = root.least(fine.root.value),
      .root_high = root.most(fine.root.value),
      .deflection_low = deflection.least(fine.deflection.value),
      .deflection_high = deflection.most(fine.deflection.value),
      .largest = largest};
}

template std::optional<ResponseScatter> response_scatter<2>(
    const PartJob&, const ImpactJob&, const std::vector<stress::SingularZone>&,
    int, const StruckRun<2>&, const StruckRun<2>&, StruckFaces<2>&);
template std::optional<ResponseScatter> response_scatter<3>(
    const PartJob&, const ImpactJob&, const std::vector<stress::SingularZone>&,
    int, const StruckRun<3>&, const StruckRun<3>&, StruckFaces<3>&);

}  // namespace clevis::assessment
