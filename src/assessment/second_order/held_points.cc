#include "assessment/second_order/held_points.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "assessment/job/part_zones.h"
#include "stress/displacement/deflection.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int kSubdivisions = 2;

/// Zones of the lattice: any, where one is left out.
Eigen::MatrixXi zones_of(const PartJob& job, const PartSpace& space,
                         std::size_t set, bool leaves_out) {
  std::vector<stress::SingularZone> zones;
  if (leaves_out) {
    zones = part_zones<3>(job, job.overall_mesh(), job.load_sets[set]);
  }
  return stress::zone_of_points<3>(space.whole, kSubdivisions, zones);
}

}  // namespace

double rise_at_most(double yield) {
  constexpr double kMost = 100.0;
  return yield < 1.0 ? std::min(kMost, 1.0 / (1.0 - yield)) : kMost;
}

LinearSet::LinearSet(const PartJob& job, const PartSpace& space,
                     const SecondOrderLoads& looked,
                     const std::vector<InstantRow>& rows,
                     const PartResult& result)
    : job_(job),
      space_(space),
      looked_(looked),
      judged_(judged_peak(result)),
      swing_(swing_of(result, looked.set)),
      zone_of_(zones_of(job, space, looked.set, &judged_ != &result.peak)),
      checked_(result, rows, looked.set, swing_) {}

void LinearSet::take_points(const elasticity::StressedPart& part) {
  common_ = common_load(looked_, part.coefficients());
  points_ = load_points(
      looked_, part.coefficients(),
      [&](Index instant) {
        return part.pushes().gain(instant);
      },
      [&](const loads::InstantLoad& instant) {
        return checked_.refers_to(instant.label, instant.time);
      });
}

bool LinearSet::is_spun_in_part(const LoadPoint& point) const {
  return common_ && point.is_motion && looked_.pressed == 0.0;
}

double LinearSet::yield(const LoadPoint& point, double lowest) const {
  const double spin = point.omega.norm() / lowest;
  return looked_.pressed + (!(spin <= kSlowSpin) ? spin * spin : 0.0);
}

bool LinearSet::is_slow(double frequency) const {
  return std::ranges::all_of(looked_.instants, [&](const auto& instant) {
    return instant.rigid.omega.norm() <= kSlowSpin * frequency;
  });
}

LinearSet::Measured LinearSet::measured(const MatrixXd& columns,
                                        const MatrixXd& amounts) const {
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = space_.whole;
  basis.columns = columns;
  basis.coefficients = amounts;
  return {stress::peaks_outside<3>(basis, job_.part.material, kSubdivisions,
                                   zone_of_),
          stress::largest_deflection<3>(basis).of_instant};
}

std::vector<LinearPoint> LinearSet::linear(const std::vector<LoadPoint>& points,
                                           const Measured& here) const {
  return checked_.of(points, here.first, here.second);
}

bool LinearSet::is_seen(const Measured& here) const {
  return here.first.maxCoeff() > 0.0 || !(judged_.value > 0.0);
}

HeldPoints::HeldPoints(const LinearSet& set,
                       const elasticity::StressedPart& part,
                       const elasticity::HeldPart& held, std::size_t hold,
                       double lowest)
    : set_(set), part_(part), hold_(hold) {
  take_points(held);
  if (points_.empty()) return;
  const MatrixXd columns = part.displaced(hold);
  MatrixXd amounts(columns.cols(), static_cast<Index>(points_.size()));
  for (Index i = 0; i < amounts.cols(); ++i) {
    amounts.col(i) = points_[static_cast<std::size_t>(i)].amounts;
  }
  const auto here = set.measured(columns, amounts);
  linear_ = set.linear(points_, here);
  is_seen_ = amounts.isZero() || set.is_seen(here);
  for (const LoadPoint& point : points_) {
    yields_.push_back(set.yield(point, lowest));
  }
  if (!set.common()) return;
  const auto [stress, way] = set.measured(columns, *set.common());
  common_peak_ = stress[0];
  common_deflection_ = way[0];
}

void HeldPoints::take_points(const elasticity::HeldPart& held) {
  const std::vector<LoadPoint>& all = set_.points();
  const auto is_held = [&](std::size_t i, std::size_t by) {
    return held.is_held(by, all[i].instant);
  };
  // Each with the next that it goes on to.
  const auto is_taken = [&](std::size_t i) {
    return is_held(i, hold_) ||
           (i > 0 && all[i - 1].goes_on && is_held(i - 1, hold_));
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_taken(i)) continue;
    points_.push_back(all[i]);
    points_.back().goes_on = all[i].goes_on && is_taken(i + 1);
    bool is_first = is_held(i, hold_);
    for (std::size_t by = 0; by < hold_; ++by) is_first &= !is_held(i, by);
    is_first_hold_.push_back(is_first);
  }
}

double HeldPoints::at_most(std::size_t i, bool by_stress, double yield) const {
  const LinearPoint& of = linear_[i];
  const double value = by_stress ? of.peak : of.deflects;
  const double spun =
      std::min(value, by_stress ? common_peak_ : common_deflection_);
  const Swing swing = set_.swing(points_[i]);
  return (by_stress ? swing.stress : swing.deflection) *
         (value + (rise_at_most(yield) - 1.0) *
                      (set_.is_spun_in_part(points_[i]) ? spun : value));
}

double HeldPoints::most() const {
  double most = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    most = std::max(most, at_most(i, true));
  }
  return most;
}

std::vector<std::size_t> HeldPoints::by_most(bool by_stress) const {
  std::vector<std::size_t> order(size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) {
    return at_most(i, by_stress);
  });
  return order;
}

LinearPoint HeldPoints::linear_between(std::size_t from,
                                       const LoadPoint& between) const {
  const auto [stress, way] = set_.measured(
      part_.displaced(between.amounts, hold_), MatrixXd::Ones(1, 1));
  return linear_[from].between(linear_[from + 1], stress[0], way[0]);
}

}  // namespace clevis::assessment
