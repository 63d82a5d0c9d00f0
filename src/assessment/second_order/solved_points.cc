#include "assessment/second_order/solved_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace clevis::assessment {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SolvedPoints::SolvedPoints(const LinearSet& linear,
                           const elasticity::StressedPart& part,
                           const HeldPoints& points, std::vector<bool> bent,
                           double softer, const PartResult& result,
                           SecondOrderResult& found)
    : linear_(linear),
      points_(points),
      bent_(std::move(bent)),
      softer_(softer),
      result_(result),
      found_(found),
      part_(part) {}

SolvedPoints::Reached SolvedPoints::take(std::size_t i) {
  return take(i, points_.point(i), points_.linear(i), points_.yield(i));
}

SolvedPoints::Reached SolvedPoints::take_between(std::size_t from,
                                                 double share) {
  const LoadPoint point =
      between(points_.point(from), points_.point(from + 1), share);
  return take(from, point, points_.linear_between(from, point),
              std::max(points_.yield(from), points_.yield(from + 1)));
}

SolvedPoints::Solver::Answer SolvedPoints::answer(
    const LoadPoint& point, double more, const Eigen::Vector3d& omega) {
  const auto& common = linear_.common();
  const bool turns = common && point.is_motion && !omega.isZero();
  const VectorXd spun = turns ? *common : point.amounts;
  if (!solver_) solver_.emplace(part_, points_.hold());
  return solver_->answer({.stressing = more * point.amounts,
                          .gain = more * point.gain,
                          .spun = spun,
                          .still = point.amounts - spun,
                          .omega = omega});
}

double SolvedPoints::certain(double rise) const {
  const BucklingResult& buckling = result_.buckling;
  const double low = buckling.band_low - 1.0;
  const double high = buckling.band_high - 1.0;
  return buckling.factor && low > 0.0 ? 1.0 + (rise - 1.0) * low / high : 1.0;
}

std::optional<SolvedPoints::Rise> SolvedPoints::rise_of(
    const LoadPoint& point, const LinearPoint& linear, double more,
    const Eigen::Vector3d& omega) {
  const auto solved = answer(point, more, omega);
  if (solved.state == Solver::State::kOpen) {
    found_.failure = "its solution at " + point.label + " does not settle";
    return std::nullopt;
  }
  if (solved.state == Solver::State::kUnstable) {
    found_.is_stable = false;
    found_.label = point.label;
    return std::nullopt;
  }
  const auto [stress, moved] =
      linear_.measured(solved.displacement, MatrixXd::Ones(1, 1));
  const auto over = [](double now, double before) {
    return before > 0.0 ? std::max(1.0, now / before) : 1.0;
  };
  return Rise{over(stress[0], linear.here), over(moved[0], linear.moved)};
}

SolvedPoints::Reached SolvedPoints::take(std::size_t i, const LoadPoint& point,
                                         const LinearPoint& linear,
                                         double yield) {
  const Swing swing = linear_.swing(point);
  const bool spins = yield > linear_.pressed();
  const Eigen::Vector3d omega =
      spins ? point.omega : Eigen::Vector3d(Eigen::Vector3d::Zero());
  auto rise = rise_of(point, linear, softer_ * swing.largest(), omega);
  if (!rise) return {};
  if (softer_ * swing.largest() > 1.0 && spins) {
    // What spins may be stiffened by its stresses.
    const auto less = rise_of(point, linear, 1.0, omega);
    if (!less) return {};
    rise->stress = std::max(rise->stress, less->stress);
    rise->deflection = std::max(rise->deflection, less->deflection);
  }
  Reached reached;
  reached.peak = swing.stress * rise->stress * linear.peak;
  if (bent_[static_cast<std::size_t>(point.instant)]) {
    found_.bound =
        std::max(found_.bound, swing.stress * linear.peak *
                                   std::max(rise->stress, rise->deflection));
  }
  if (reached.peak > found_.peak) {
    found_.peak = reached.peak;
    found_.stress = rise->stress;
    found_.label = point.label;
  }
  const bool is_still = swing.largest() == 1.0;
  if (is_still) {
    found_.least_peak =
        std::max(found_.least_peak,
                 certain(rise->stress) *
                     (linear.is_peak_known ? linear.peak : linear.here));
  }
  constexpr double kRises = 1.001;  // else linear theory's own stands
  if (!points_.is_first_hold(i) || !(rise->deflection > kRises)) {
    return reached;
  }
  reached.deflection = swing.deflection * rise->deflection * linear.deflects;
  if (reached.deflection > found_.deflection) {
    found_.deflection = reached.deflection;
    found_.deflection_rise = rise->deflection;
  }
  if (is_still) {
    found_.least_deflection = std::max(
        found_.least_deflection,
        certain(rise->deflection) *
            (linear.is_deflection_known ? linear.deflects : linear.moved));
  }
  return reached;
}

void SolvedPoints::look_at_growth(double wanted) {
  constexpr std::size_t kMost = 4;
  std::vector<std::size_t> order(points_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) {
    const double yield = points_.yield(i);
    return !(yield > linear_.pressed()) || yield * wanted < 1.0;
  });
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) {
    return points_.yield(i);
  });
  if (order.size() > kMost) order.resize(kMost);
  for (const std::size_t i : order) {
    const LoadPoint& point = points_.point(i);
    // What spins may be stiffened by its stresses.
    for (const double more : {softer_ * linear_.swing(point).largest(), 1.0}) {
      const auto solved =
          answer(point, wanted * more, std::sqrt(wanted) * point.omega);
      if (solved.state == Solver::State::kStable) continue;
      found_.bears_growth = false;
      found_.label = point.label;
      return;
    }
  }
}

}  // namespace clevis::assessment
