#include "assessment/second_order/second_order_check.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

#include "assessment/buckling/buckling_check.h"
#include "assessment/buckling/buckling_model.h"
#include "assessment/buckling/part_holds.h"
#include "assessment/pace/load_pace.h"
#include "assessment/second_order/held_points.h"
#include "assessment/second_order/second_order_loads.h"
#include "assessment/second_order/solved_points.h"
#include "assessment/verdict/governing_peak.h"
#include "base/messages/errors.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/buckling/stressed_part.h"
#include "elasticity/problem/dof_limit.h"
#include "loads/holds/holding_groups.h"
#include "part/buckling_limit.h"

namespace clevis::assessment {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using elasticity::StressedPart;
using loads::InstantLoad;

/// How many instants are solved for that may decide a limit.
int most_solved(const PartSpace& space) {
  constexpr int kSmall = 30'000;  // dofs
  return space.whole.dofs() < kSmall ? 96 : 24;
}

/// A load set in second order.
class SetCheck {
 public:
  /// @param space  of model.lowest_degree().
  SetCheck(const PartJob& job, BucklingModel& model, const PartSpace& space,
           const SecondOrderLoads& looked, const std::vector<InstantRow>& rows,
           double of_lowest_degree, HeldMotions& held, const PartResult& result)
      : job_(job),
        held_(held),
        model_(model),
        space_(space),
        set_(job.load_sets[looked.set]),
        looked_(looked),
        result_(result),
        linear_(job, space, looked, rows, result),
        softer_(softer_by_the_band(of_lowest_degree, result.buckling)),
        admitted_peak_(buckles(job, result) ? HUGE_VAL
                                            : admitted_peak(job.part, result)),
        admitted_deflection_(buckles(job, result)
                                 ? HUGE_VAL
                                 : admitted_deflection(job.part, result)) {}

  void run(SecondOrderResult& found) {
    const bool may_be_fast = this->may_be_fast();
    if (linear_.pressed() == 0.0 && !may_be_fast) return;
    loads::LoadHistory history = set_.history;
    history.instants = looked_.instants;
    history.repeats.clear();
    holds_ = part_holds(set_, history, job_.part.ideal_joints);
    elasticity::BucklingProblem problem{
        .discretization = space_.whole,
        .material = job_.part.material,
        .history = history,
        .fixed = model_.supports(set_),
        .holds = holds_,
        .name = job_.part.name,
        .foundations = set_.foundations,
        .plane = space_.plane ? &*space_.plane : nullptr};
    model_.factor(set_, problem);
    const elasticity::HeldPart held(problem);
    std::vector<double> lowest;
    for (std::size_t hold = 0; hold < held.holds(); ++hold) {
      lowest.push_back(may_be_fast ? held.lowest_frequency(hold) : HUGE_VAL);
    }
    const auto with = may_be_fast ? with_neighbours(lowest) : std::nullopt;
    if (linear_.pressed() == 0.0 && linear_.is_slow(std::ranges::min(lowest)) &&
        !with) {
      return;
    }
    const elasticity::StressedPart part(problem, held);
    if (!part.is_stressed()) return;
    linear_.take_points(part);
    std::list<HeldPoints> holds;
    for (std::size_t hold = 0; hold < held.holds(); ++hold) {
      holds.emplace_back(linear_, part, held, hold, lowest[hold]);
      if (holds.back().size() == 0) holds.pop_back();
    }
    // The hold first with which some instant may rise to most.
    holds.sort([](const HeldPoints& one, const HeldPoints& other) {
      return one.most() > other.most();
    });
    for (const HeldPoints& points : holds) {
      SolvedPoints solved(linear_, part, points, bent(points.hold()), softer_,
                          result_, found);
      look_at(points, solved, found);
      if (with) bound_with_neighbours(*with, points, found);
      if (!found.is_stable) return;
    }
  }

 private:
  /// bent_by_pins() with a hold.
  std::vector<bool> bent(std::size_t hold) const {
    const auto positions = elasticity::node_positions(space_.whole);
    const double size =
        (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff())
            .norm();
    const bool is_free = hold < holds_.size();
    return bent_by_pins(
        set_.history.seats, looked_,
        is_free ? holds_[hold].groups : std::vector<std::string>{}, size);
  }

  /// It fails by that: nothing else decides.
  static bool buckles(const PartJob& job, const PartResult& result) {
    const double wanted = part::wanted_buckling_factor(job.part.limits);
    const BucklingResult& buckling = result.buckling;
    return buckling.euler_fails(wanted) ||
           (buckling.factor && buckling.band_high < wanted);
  }

  /// K_G of a degree whose cells are too stiff counts as the band of the
  /// buckling factor has it, with what a fluid's pressure needs less.
  static double softer_by_the_band(double of_lowest_degree,
                                   const BucklingResult& buckling) {
    return buckling.factor && buckling.band_low > 0.0
               ? std::max(1.0, of_lowest_degree / buckling.band_low)
               : 1.0;
  }

  /// With all that the mechanism holds and weighs [rad/s].
  double first_frequency() {
    return 2.0 * std::numbers::pi / held_.first_period(looked_.set);
  }

  /// Whether spin may count beside the frequency with one of the holds, which
  /// may leave the part softer than all that the mechanism holds.
  bool may_be_fast() {
    constexpr double kSofter = 10.0;  // a beam clamped at one end or both: 6.4
    return looked_.may_be_fast && !linear_.is_slow(first_frequency() / kSofter);
  }

  /// Masses that the mechanism adds, as a disc on a shaft, lower the frequency
  /// beside which the part spins [rad/s]; nothing: it does not count.
  /// @param lowest  frequencies of the part alone [rad/s].
  std::optional<double> with_neighbours(const std::vector<double>& lowest) {
    constexpr double kAdded = 0.999;
    const auto& history = set_.history;
    if (!history.hold || history.hold_that_counts().weighed.cols() == 0) {
      return std::nullopt;
    }
    const double with = first_frequency();
    if (with > kAdded * std::ranges::min(lowest) || linear_.is_slow(with)) {
      return std::nullopt;
    }
    return with;
  }

  /// Their share of the rise is bounded.
  /// @param with  frequency with them [rad/s].
  void bound_with_neighbours(double with, const HeldPoints& points,
                             SecondOrderResult& found) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double more = linear_.yield(points.point(i), with);
      found.bound = std::max(found.bound, points.at_most(i, true, more));
      found.deflection_bound =
          std::max(found.deflection_bound, points.at_most(i, false, more));
    }
  }

  void look_at(const HeldPoints& points, SolvedPoints& solved,
               SecondOrderResult& found) {
    if (!points.is_seen()) {
      found.failure = "its zones cover every point that it is looked at by";
      return;
    }
    for (const bool by_stress : {true, false}) {
      solve_most(points, by_stress, solved, found);
      if (!found.is_stable || !found.failure.empty()) return;
    }
    solved.look_at_growth(part::wanted_buckling_factor(job_.part.limits));
  }

  /// The one that may rise to most, and those that may decide the limit.
  void solve_most(const HeldPoints& points, bool by_stress,
                  SolvedPoints& solved, SecondOrderResult& found) {
    constexpr double kAlike = 1e-3;
    std::vector<LoadPoint> known;
    const double admitted = by_stress ? admitted_peak_ : admitted_deflection_;
    double& bound = by_stress ? found.bound : found.deflection_bound;
    left_ = most_solved(space_);
    left_between_ = 4 * left_;
    followed_.clear();
    bool& is_first = by_stress ? is_first_by_stress_ : is_first_by_deflection_;
    for (const std::size_t i : points.by_most(by_stress)) {
      const LoadPoint& point = points.point(i);
      const double yield = points.yield(i);
      // The check's deflection is by an instant's first hold.
      if (!(yield > 0.0) || !(by_stress || points.is_first_hold(i))) continue;
      const bool decides =
          points.at_most(i, by_stress) > admitted || yield >= 1.0;
      if (!decides && !is_first) continue;
      if (left_ <= 0) {
        bound = std::max(bound, points.at_most(i, by_stress));
        continue;
      }
      if (std::ranges::none_of(known, [&](const LoadPoint& other) {
            return point.is_like(other, kAlike);
          })) {
        is_first = false;
        --left_;
        known.push_back(point);
        solved.take(i);
      }
      if (decides && !follow_on(points, i, by_stress, solved, found)) {
        bound = std::max(bound, points.at_most(i, by_stress));
      }
      if (!found.is_stable || !found.failure.empty()) return;
    }
  }

  /// Between an instant and the next stress and deflection of second order may
  /// be larger than at both: what presses falls as what bends rises.
  /// @return whether that could be looked at.
  bool follow_on(const HeldPoints& points, std::size_t i, bool by_stress,
                 SolvedPoints& solved, const SecondOrderResult& found) {
    constexpr double kFar = 0.05;
    constexpr int kShares = 4, kHalvings = 2;
    constexpr int kSolved = kShares - 1 + 2 * kHalvings;
    for (const std::size_t from : {i - 1, i}) {
      if (i == 0 && from != i) continue;
      if (!points.point(from).goes_on || followed_.contains(from) ||
          points.point(from).is_like(points.point(from + 1), kFar)) {
        continue;
      }
      if (left_between_ < kSolved) return false;
      left_between_ -= kSolved;
      followed_.insert(from);
      double best = 0.5, step = 1.0 / kShares, most = -1.0;
      const auto look = [&](double share) {
        if (!found.is_stable || !found.failure.empty()) return;
        const SolvedPoints::Reached reached = solved.take_between(from, share);
        const double value = by_stress ? reached.peak : reached.deflection;
        if (value <= most) return;
        most = value;
        best = share;
      };
      for (int k = 1; k < kShares; ++k) look(k * step);
      for (int k = 0; k < kHalvings; ++k) {
        step *= 0.5;
        const double middle = best;
        look(middle - step);
        look(middle + step);
      }
    }
    return true;
  }

  const PartJob& job_;
  HeldMotions& held_;
  BucklingModel& model_;
  const PartSpace& space_;
  const LoadSet& set_;
  const SecondOrderLoads& looked_;
  const PartResult& result_;
  LinearSet linear_;
  double softer_;
  double admitted_peak_, admitted_deflection_;
  std::vector<elasticity::HoldingSeats> holds_;
  std::set<std::size_t> followed_;  ///< points, on to the next
  /// Nothing was solved for yet, with any hold.
  bool is_first_by_stress_ = true, is_first_by_deflection_ = true;
  /// So many instants may be solved for, and places between them.
  int left_{}, left_between_{};
};

/// Without a solution: bounded by the buckling factor; of spin that is not slow
/// beside a bar of the part's size nothing is known.
void bound(const PartJob& job, const SecondOrderLoads& looked,
           const Error& error, const PartResult& result,
           SecondOrderResult& found) {
  const LoadSet& set = job.load_sets[looked.set];
  const bool is_flat = error.code() == "F001";  // free across its plane
  const double period =
      is_flat ? longest_period_in_plane(job)
              : result.first_period.value_or(longest_period(job, set));
  const bool is_fast =
      std::ranges::any_of(looked.instants, [&](const InstantLoad& instant) {
        return instant.rigid.omega.norm() * period >
               kSlowSpin * 2.0 * std::numbers::pi;
      });
  if (is_fast) found.failure = error.problem();
  if (looked.pressed == 0.0) return;
  const Swing swing = swing_of(result, looked.set);
  const double rise = rise_at_most(looked.pressed);
  found.bound =
      std::max(found.bound, rise * swing.stress * judged_peak(result).value);
  found.deflection_bound =
      std::max(found.deflection_bound, rise * result.deflection);
}

void note(const PartResult& result, std::vector<std::string>& notes) {
  constexpr double kSays = 1.01;
  const SecondOrderResult& found = result.second_order;
  if (!found.is_stable) return;
  if (found.bound > kSays * std::max(found.peak, judged_peak(result).value)) {
    notes.push_back(fmt::format(
        "second order: loads, and masses of other bodies that it spins, act on "
        "what they displace, and pins bend what they hold: up to {:.4g} MPa, "
        "which is the verdict's bound",
        1e-6 * found.bound));
  }
  if (found.peak > 0.0 && found.stress > kSays) {
    notes.push_back(fmt::format(
        "second order: loads act on what they displace, {:.4g} MPa ({}), "
        "{:.3f} "
        "of linear theory's there; the verdict has it, the table is of linear "
        "theory",
        1e-6 * found.peak, found.label, found.stress));
  }
  if (found.deflection_rise > kSays) {
    notes.push_back(fmt::format(
        "second order: deflection {:.4g} mm, {:.3f} of linear theory's then",
        1e3 * found.deflection, found.deflection_rise));
  }
}

SecondOrderResult second_order(const PartJob& job,
                               const std::vector<InstantRow>& rows,
                               double of_lowest_degree, HeldMotions& held,
                               BucklingModel& model, const PartResult& result) {
  std::optional<PartSpace> space;
  SecondOrderResult found;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const SecondOrderLoads looked = second_order_loads(job, s, result);
    if (looked.instants.empty()) continue;
    try {
      if (!space) {
        space = model.discretize(model.lowest_degree());
        elasticity::require_dofs(space->whole.dofs(), job.max_dofs,
                                 "part " + job.part.name);
      }
      SetCheck(job, model, *space, looked, rows, of_lowest_degree, held, result)
          .run(found);
    } catch (const Error& error) {
      if (!is_bearable(error)) throw;
      bound(job, looked, error, result, found);
    }
    if (!found.is_stable) break;
  }
  return found;
}

}  // namespace

void check_second_order(const PartJob& job, const std::vector<InstantRow>& rows,
                        double of_lowest_degree, HeldMotions& held,
                        BucklingModel& model, PartResult& result) {
  const auto check = [&] {
    result.second_order =
        second_order(job, rows, of_lowest_degree, held, model, result);
  };
  check();
  const SecondOrderResult& found = result.second_order;
  const bool decides =
      found.least_peak > admitted_peak(job.part, result) ||
      found.least_deflection > admitted_deflection(job.part, result);
  if (decides &&
      widen_by_all_holds(job, result.swings, model, result.buckling)) {
    check();  // what is certain of its rise
  }
  note(result, result.notes);
}

double bent_further(double factor) {
  return 1.0 / (1.0 - 1.0 / factor);
}

void bound_by_buckling_together(double together, double counted,
                                const std::string& why, PartResult& result) {
  SecondOrderResult& second = result.second_order;
  if (together <= 1.0) {
    if (second.failure.empty()) second.failure = why;
    return;
  }
  const double rise = bent_further(together) / counted;
  const double peak = std::max(second.peak, governing_peak(result).value);
  second.bound = std::max(second.bound, rise * peak);
  const double deflection = std::max(second.deflection, result.deflection);
  second.deflection_bound =
      std::max(second.deflection_bound, rise * deflection);
}

void bound_on_springs(const elasticity::BucklingMode::OnSprings& on,
                      PartResult& result) {
  const BucklingResult& buckling = result.buckling;
  if (!on.counts() || !buckling.factor) return;
  if (buckling.band_low >= kFirstOrderIsEnough) return;
  const double own = std::max(on.own, 1.0 / buckling.band_low);
  if (!on.rises() && own >= 1.0) return;  // it buckles by itself
  // The motion of the mechanism has what its springs yield.
  double counted = bent_further(1.0 / on.springs);
  if (result.second_order.peak > 0.0) counted *= bent_further(1.0 / own);
  bound_by_buckling_together(
      buckling.band_low, counted,
      fmt::format(
          "on the springs that hold it the part may buckle under {:.4g} "
          "times its loads",
          buckling.band_low),
      result);
}

}  // namespace clevis::assessment
