#include "assessment/stability/second_order_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>

#include "assessment/job/part_zones.h"
#include "assessment/judge/verdict.h"
#include "assessment/stability/buckling_model.h"
#include "assessment/vibration/load_pace.h"
#include "base/messages/errors.h"
#include "elasticity/buckling/second_order.h"
#include "elasticity/problem/dof_limit.h"
#include "loads/history/motion_instants.h"
#include "loads/seats/holding_groups.h"
#include "stress/field/deflection.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using elasticity::SecondOrderPart;
using loads::InstantLoad;

constexpr double kFirstOrderIsEnough = 10.0;  // times its loads
constexpr double kSlow = 0.1;                 // spin over lowest frequency
constexpr int kSubdivisions = 2;

/// What the part yields to a load at most, over linear theory's [1].
/// @param yield  1/λ + (Ω/ω)² of buckling and whirling.
double rise_at(double yield) {
  constexpr double kMost = 100.0;
  return yield < 1.0 ? std::min(kMost, 1.0 / (1.0 - yield)) : kMost;
}

/// Of a load set's motion.
Swing swing_of(const PartResult& result, std::size_t set) {
  return result.swings.empty() ? Swing{} : result.swings[set];
}

/// Share of what buckles the part that a load set has, 1/λ; 0: first order is
/// enough [1].
double pressed(const PartResult& result, const Swing& swing) {
  if (!result.buckling.factor) return 0.0;
  const double share = swing.largest() / result.buckling.band_low;
  return share * kFirstOrderIsEnough > 1.0 ? share : 0.0;
}

/// Instants of a load set that are looked at: the motion's before the cases'.
struct Looked {
  std::size_t set{};
  std::vector<InstantLoad> instants;
  std::size_t motion{};  ///< so many of them
  double pressed{};      ///< of the set
  bool may_be_fast{};    ///< its spin, beside the lowest frequency
};

Looked looked_at(const PartJob& job, std::size_t s, const PartResult& result) {
  const LoadSet& set = job.load_sets[s];
  const std::size_t motion = loads::motion_length(set.history);
  const double slow = kSlow * 2.0 * std::numbers::pi / softest_period(job, set);
  Looked looked{s, {}, 0, pressed(result, swing_of(result, s)), false};
  const auto& all = set.history.instants;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool may_be_fast = all[i].rigid.omega.norm() > slow;
    looked.may_be_fast |= may_be_fast;
    if (looked.pressed == 0.0 && !may_be_fast) continue;
    looked.instants.push_back(all[i]);
    if (motion > 1 && i < motion) looked.motion = looked.instants.size();
  }
  return looked;
}

/// What the loads of a motion that turns on at one speed have in common in the
/// part's frame, where those that stand still in space turn: least squares of
/// c0 + c1 cos θ + c2 sin θ. Nothing of other motions: there each instant's
/// loads move on with what they displace.
std::optional<VectorXd> common_load(const Looked& looked,
                                    const MatrixXd& coefficients) {
  constexpr double kSteady = 0.02;
  const auto count = static_cast<Index>(looked.motion);
  if (count < 4) return std::nullopt;
  const auto& instants = looked.instants;
  const Eigen::Vector3d first = instants.front().rigid.omega;
  Eigen::MatrixX3d terms(count, 3);
  double turned = 0.0;
  for (Index i = 0; i < count; ++i) {
    const InstantLoad& here = instants[static_cast<std::size_t>(i)];
    const Eigen::Vector3d& omega = here.rigid.omega;
    if ((omega - first).norm() > kSteady * first.norm()) return std::nullopt;
    turned = omega.norm() * (here.time - instants.front().time);
    terms.row(i) << 1.0, std::cos(turned), std::sin(turned);
  }
  if (turned < std::numbers::pi) return std::nullopt;
  const MatrixXd fit = terms.colPivHouseholderQr().solve(
      coefficients.leftCols(count).transpose());
  return VectorXd(fit.row(0).transpose());
}

/// A load set in second order.
class SetCheck {
 public:
  SetCheck(const PartJob& job, const PartSpace& space, const Looked& looked,
           const std::vector<InstantRow>& rows, const PartResult& result)
      : job_(job),
        space_(space),
        set_(job.load_sets[looked.set]),
        looked_(looked),
        result_(result),
        judged_(judged_peak(result)),
        swing_(swing_of(result, looked.set)),
        admitted_peak_(admitted_peak(job.part, result)),
        admitted_deflection_(admitted_deflection(job.part, result)),
        zone_of_(zones()) {
    for (const InstantRow& row : rows) {
      if (row.load_set == looked.set) peaks_[{row.label, row.time}] = row.peak;
    }
  }

  void run(SecondOrderResult& found) {
    loads::LoadHistory history = set_.history;
    history.instants = looked_.instants;
    history.repeats.clear();
    const elasticity::BucklingProblem problem{
        space_.whole,
        job_.part.material,
        history,
        set_.fixed,
        loads::holding_groups(set_.history),
        job_.part.name,
        set_.foundations,
        space_.plane ? &*space_.plane : nullptr};
    const SecondOrderPart part(problem);
    if (!part.is_stressed()) return;
    common_ = common_load(looked_, part.coefficients());
    for (std::size_t hold = 0; hold < part.holds() && found.is_stable; ++hold) {
      look_at(part, hold, found);
    }
  }

 private:
  using Measured = std::pair<VectorXd, VectorXd>;  ///< by instant [Pa], [m]

  /// Of the lattice: in any zone, where one is left out.
  Eigen::MatrixXi zones() const {
    std::vector<stress::SingularZone> zones;
    if (&judged_ != &result_.peak) {
      zones = part_zones<3>(job_, job_.overall_mesh(), set_);
    }
    return stress::zone_of_points<3>(space_.whole, kSubdivisions, zones);
  }

  Measured measured(const MatrixXd& columns, const MatrixXd& amounts) const {
    elasticity::DisplacementBasis<3> basis;
    basis.discretization = space_.whole;
    basis.columns = columns;
    basis.coefficients = amounts;
    return {stress::peaks_outside<3>(basis, job_.part.material, kSubdivisions,
                                     zone_of_),
            stress::largest_deflection<3>(basis).of_instant};
  }

  bool is_judged(const InstantLoad& instant) const {
    return instant.label == judged_.label && instant.time == judged_.instant;
  }

  /// By linear theory, with the degrees of the check where these are known
  /// [Pa].
  VectorXd checked(const VectorXd& here) const {
    constexpr double kOfDegree = 1.05;  // where only this low one is known
    double scale = kOfDegree;
    for (Index i = 0; i < here.size(); ++i) {
      if (is_judged(looked_.instants[static_cast<std::size_t>(i)]) &&
          here[i] > 0.0) {
        scale = std::max(1.0, judged_.value / here[i]);
      }
    }
    VectorXd checked = scale * here;
    if (&judged_ != &result_.peak) return checked;
    for (Index i = 0; i < here.size(); ++i) {
      const InstantLoad& instant =
          looked_.instants[static_cast<std::size_t>(i)];
      const auto row = peaks_.find({instant.label, instant.time});
      if (row != peaks_.end()) checked[i] = row->second;
    }
    return checked;
  }

  void look_at(const SecondOrderPart& part, std::size_t hold,
               SecondOrderResult& found) {
    constexpr int kMost = 24, kAlways = 2;
    const MatrixXd columns = part.columns(hold);
    const auto [here, moved] = measured(columns, part.coefficients());
    if (!(here.maxCoeff() > 0.0) && judged_.value > 0.0) {
      found.failure = "its zones cover every point that it is looked at by";
      return;
    }
    const VectorXd peak = checked(here);
    std::pair<double, double> common{};  // of what is spun alone [Pa], [m]
    if (common_) {
      const auto [stress, way] = measured(columns, *common_);
      common = {stress[0], way[0]};
    }
    const double lowest =
        looked_.may_be_fast ? part.lowest_frequency(hold) : HUGE_VAL;
    const VectorXd yield = yields(lowest);
    std::vector<std::size_t> order(looked_.instants.size()), solved;
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (const bool by_stress : {true, false}) {
      if (!by_stress && hold > 0) break;  // the check's is of the first
      const auto most = [&](std::size_t i) {
        const auto at = static_cast<Index>(i);
        const double value = by_stress ? peak[at] : moved[at];
        const double rises =
            std::min(value, by_stress ? common.first : common.second);
        const double swung = by_stress ? swing(i).stress : swing(i).deflection;
        return swung * (value + (rise_at(yield[at]) - 1.0) *
                                    (is_spun_in_part(i) ? rises : value));
      };
      std::ranges::stable_sort(order, std::ranges::greater{}, most);
      const double admitted = by_stress ? admitted_peak_ : admitted_deflection_;
      int left = kMost;
      for (const std::size_t i : order) {
        const auto at = static_cast<Index>(i);
        if (!(yield[at] > 0.0) || is_like_one(i, solved, part.coefficients())) {
          continue;
        }
        const bool decides = most(i) > admitted || yield[at] >= 1.0;
        if (!decides && left <= kMost - kAlways) continue;
        if (left == 0) {
          double& bound = by_stress ? found.bound : found.deflection_bound;
          bound = std::max(bound, most(i));
          continue;
        }
        --left;
        solved.push_back(i);
        take(part, {i, hold, here[at], peak[at], moved[at]}, found);
        if (!found.is_stable || !found.failure.empty()) return;
      }
    }
  }

  /// 1/λ + (Ω/ω)² at most, by instant; 0: first order is enough.
  /// @param lowest  frequency ω [rad/s].
  VectorXd yields(double lowest) const {
    VectorXd yields(static_cast<Index>(looked_.instants.size()));
    for (std::size_t i = 0; i < looked_.instants.size(); ++i) {
      const double spin = looked_.instants[i].rigid.omega.norm() / lowest;
      yields[static_cast<Index>(i)] =
          looked_.pressed + (!(spin <= kSlow) ? spin * spin : 0.0);
    }
    return yields;
  }

  /// Whether loads and spin of an instant that was solved for are the same.
  bool is_like_one(std::size_t i, const std::vector<std::size_t>& solved,
                   const MatrixXd& coefficients) const {
    constexpr double kAlike = 1e-3;
    const auto here = coefficients.col(static_cast<Index>(i));
    const Eigen::Vector3d& omega = looked_.instants[i].rigid.omega;
    return std::ranges::any_of(solved, [&](std::size_t k) {
      const auto there = coefficients.col(static_cast<Index>(k));
      return is_motion(k) == is_motion(i) &&
             (looked_.instants[k].rigid.omega - omega).norm() <=
                 kAlike * omega.norm() &&
             (there - here).norm() <= kAlike * here.norm();
    });
  }

  /// Whether all that rises is what the motion's loads have in common.
  bool is_spun_in_part(std::size_t i) const {
    return common_ && is_motion(i) && looked_.pressed == 0.0;
  }
  bool is_motion(std::size_t i) const { return i < looked_.motion; }
  Swing swing(std::size_t i) const {
    return is_motion(i) ? swing_ : Swing{};  // cases stand still
  }

  /// An instant by linear theory.
  struct Linear {
    std::size_t instant{}, hold{};
    double here{}, peak{};  ///< by this degree, and by the check's [Pa]
    double moved{};         ///< [m]
  };

  void take(const SecondOrderPart& part, const Linear& linear,
            SecondOrderResult& found) {
    const InstantLoad& instant = looked_.instants[linear.instant];
    const VectorXd all =
        part.coefficients().col(static_cast<Index>(linear.instant));
    const bool turns = common_ && is_motion(linear.instant);
    const VectorXd spun = turns ? *common_ : all;
    const Swing swing = this->swing(linear.instant);
    const auto answer = part.answer({.stressing = swing.largest() * all,
                                     .spun = spun,
                                     .still = all - spun,
                                     .omega = instant.rigid.omega},
                                    linear.hold);
    if (answer.state == SecondOrderPart::State::kOpen) {
      found.failure = "its solution at " + instant.label + " does not settle";
      return;
    }
    if (answer.state == SecondOrderPart::State::kUnstable) {
      found.is_stable = false;
      found.label = instant.label;
      return;
    }
    const auto [stress, moved] =
        measured(answer.displacement, MatrixXd::Ones(1, 1));
    const double rise =
        linear.here > 0.0 ? std::max(1.0, stress[0] / linear.here) : 1.0;
    const double peak = rise * linear.peak;
    if (swing.stress * peak > found.peak) {
      found.peak = swing.stress * peak;
      found.stress = rise;
      found.label = instant.label;
    }
    if (swing.largest() == 1.0) {
      found.still_peak = std::max(found.still_peak, peak);
    }
    constexpr double kRises = 1.001;  // else linear theory's own stands
    if (linear.hold > 0 || !(moved[0] > kRises * linear.moved)) return;
    if (swing.deflection * moved[0] > found.deflection) {
      found.deflection = swing.deflection * moved[0];
      found.deflection_rise = moved[0] / linear.moved;
    }
  }

  const PartJob& job_;
  const PartSpace& space_;
  const LoadSet& set_;
  const Looked& looked_;
  const PartResult& result_;
  const PeakStress& judged_;
  Swing swing_;
  double admitted_peak_, admitted_deflection_;
  Eigen::MatrixXi zone_of_;
  std::map<std::pair<std::string, double>, double> peaks_;  ///< of the check
  std::optional<VectorXd> common_;
};

/// Without a solution: bounded by the buckling factor; of spin that is not slow
/// beside a bar of the part's size nothing is known.
void bound(const PartJob& job, const Looked& looked, const Error& error,
           const PartResult& result, SecondOrderResult& found) {
  const LoadSet& set = job.load_sets[looked.set];
  const double period = result.first_period.value_or(longest_period(job, set));
  const bool is_fast =
      std::ranges::any_of(looked.instants, [&](const InstantLoad& instant) {
        return instant.rigid.omega.norm() * period >
               kSlow * 2.0 * std::numbers::pi;
      });
  if (is_fast) found.failure = error.problem();
  if (looked.pressed == 0.0) return;
  const Swing swing = swing_of(result, looked.set);
  const double rise = rise_at(looked.pressed);
  found.bound =
      std::max(found.bound, rise * swing.stress * judged_peak(result).value);
  found.deflection_bound =
      std::max(found.deflection_bound, rise * result.deflection);
}

void note(const PartResult& result, std::vector<std::string>& notes) {
  constexpr double kSays = 1.01;
  const SecondOrderResult& found = result.second_order;
  if (!found.is_stable) return;
  if (found.peak > 0.0 && found.stress > kSays) {
    notes.push_back(fmt::format(
        "second order: loads act on what they displace, {:.4g} MPa at {}, "
        "{:.3f} of linear theory's there; the verdict has it, the table is of "
        "linear theory",
        1e-6 * found.peak, found.label, found.stress));
  }
  if (found.deflection_rise > kSays) {
    notes.push_back(fmt::format(
        "second order: deflection {:.4g} mm, {:.3f} of linear theory's then",
        1e3 * found.deflection, found.deflection_rise));
  }
}

}  // namespace

void check_second_order(const PartJob& job, const std::vector<InstantRow>& rows,
                        PartResult& result) {
  std::optional<PartSpace> space;
  SecondOrderResult& found = result.second_order;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const Looked looked = looked_at(job, s, result);
    if (looked.instants.empty()) continue;
    try {
      if (!space) {
        const BucklingModel model(job);
        space = model.discretize(model.is_compact() ? 2 : 3);
        elasticity::require_dofs(space->whole.dofs(), job.max_dofs,
                                 "part " + job.part.name);
      }
      SetCheck(job, *space, looked, rows, result).run(found);
    } catch (const Error& error) {
      if (!is_bearable(error)) throw;
      bound(job, looked, error, result, found);
    }
    if (!found.is_stable) break;
  }
  note(result, result.notes);
}

}  // namespace clevis::assessment
