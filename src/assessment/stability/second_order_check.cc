#include "assessment/stability/second_order_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>

#include "assessment/job/part_zones.h"
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
using loads::InstantLoad;

constexpr double kFirstOrderIsEnough = 10.0;
constexpr int kSubdivisions = 2;

/// By how much more a part strains that buckles at λ times its loads: as its
/// buckling shape, at most [1].
double rise_at(double factor) {
  constexpr double kMost = 100.0;
  return factor > 1.0 ? std::min(kMost, 1.0 / (1.0 - 1.0 / factor)) : kMost;
}

bool presses(const PartResult& result) {
  return result.buckling.factor &&
         result.buckling.band_low < kFirstOrderIsEnough;
}

constexpr double kSlow = 0.1;  // spin over the lowest frequency

/// Whether spin may not be slow beside the lowest vibration of a part of this
/// size and material, be it on a neck or on beds.
bool may_be_fast(const PartJob& job, const LoadSet& set,
                 const InstantLoad& instant) {
  constexpr double kNeck = 40.0;
  return instant.rigid.omega.norm() * kNeck * longest_period(job, set) >
         kSlow * 2.0 * std::numbers::pi;
}

/// Instants of a set that are looked at; the motion's stand before the cases'.
struct Looked {
  std::vector<InstantLoad> instants;
  std::size_t motion{};  ///< so many of them
};

Looked looked_at(const PartJob& job, const LoadSet& set,
                 const PartResult& result) {
  Looked looked;
  const std::size_t motion = loads::motion_length(set.history);
  const auto& all = set.history.instants;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!presses(result) && !may_be_fast(job, set, all[i])) continue;
    looked.instants.push_back(all[i]);
    if (i < motion) looked.motion = looked.instants.size();
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

double largest_displacement(const VectorXd& u) {
  return std::sqrt(
      u.reshaped(3, u.size() / 3).colwise().squaredNorm().maxCoeff());
}

/// A load set in second order.
class SetCheck {
 public:
  SetCheck(const PartJob& job, const PartSpace& space, std::size_t set,
           const std::vector<InstantRow>& rows, const PartResult& result)
      : job_(job),
        space_(space),
        set_(job.load_sets[set]),
        result_(result),
        swing_(result.swings.empty() ? 1.0 : result.swings[set]),
        looked_(looked_at(job, set_, result)) {
    for (const InstantRow& row : rows) {
      if (row.load_set == set) rows_.push_back(row);
    }
  }

  bool is_empty() const { return looked_.instants.empty(); }

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
    const elasticity::SecondOrderPart part(problem);
    if (!part.is_stressed()) return;
    mask();
    common_ = common_load(looked_, part.coefficients());
    for (std::size_t hold = 0; hold < part.holds(); ++hold) {
      look_at(part, hold, found);
    }
  }

 private:
  /// Lattice points that are left out: in any zone, where one is.
  void mask() {
    zone_of_ = Eigen::MatrixXi::Constant(
        Index(elasticity::lattice<3>(space_.whole.shape, kSubdivisions).cols()),
        space_.whole.cells(), -1);
    if (&judged_peak(result_) == &result_.peak) return;
    zone_of_ = stress::zone_of_points<3>(
        space_.whole, kSubdivisions,
        part_zones<3>(job_, job_.overall_mesh(), set_));
  }

  VectorXd peaks(const elasticity::DisplacementBasis<3>& basis) const {
    return stress::peaks_outside<3>(basis, job_.part.material, kSubdivisions,
                                    zone_of_);
  }

  /// By linear theory and the degrees of the check [Pa].
  double checked_peak(std::size_t i, double here, double largest) const {
    const PeakStress& judged = judged_peak(result_);
    const InstantLoad& instant = looked_.instants[i];
    if (&judged == &result_.peak) {
      const auto row = std::ranges::find_if(rows_, [&](const InstantRow& r) {
        return r.label == instant.label && r.time == instant.time;
      });
      if (row != rows_.end()) return row->peak;
    }
    return std::max(here, largest > 0.0 ? here / largest * judged.value : here);
  }

  void look_at(const elasticity::SecondOrderPart& part, std::size_t hold,
               SecondOrderResult& found) {
    constexpr std::size_t kMost = 24, kAlways = 2;
    elasticity::DisplacementBasis<3> basis;
    basis.discretization = space_.whole;
    basis.columns = part.columns(hold);
    basis.coefficients = part.coefficients();
    const VectorXd stress = peaks(basis);
    const VectorXd moved = stress::largest_deflection<3>(basis).of_instant;
    const double largest = stress.maxCoeff();
    const double lowest =
        std::ranges::any_of(looked_.instants,
                            [&](const InstantLoad& instant) {
                              return may_be_fast(job_, set_, instant);
                            })
            ? part.lowest_frequency(hold)
            : HUGE_VAL;
    double common = 0.0;  // what moves on stresses so much [Pa]
    if (common_) {
      basis.coefficients = *common_;
      common = peaks(basis)[0];
    }
    // 1/λ and (Ω/ω)² add up where both act on one shape.
    const auto bound_at = [&](std::size_t i) {
      const double spin = looked_.instants[i].rigid.omega.norm() / lowest;
      const double of_spin = spin > kSlow ? spin * spin : 0.0;
      const double of_press =
          presses(result_) ? 1.0 / result_.buckling.band_low : 0.0;
      const double sum = of_spin + of_press;
      const double rise = sum > 0.0 ? rise_at(1.0 / sum) : 1.0;
      if (!common_ || i >= looked_.motion) return rise;
      const double here = stress[static_cast<Index>(i)];
      return here > 0.0 ? 1.0 + (rise - 1.0) * std::min(1.0, common / here)
                        : rise;
    };
    std::vector<std::size_t> order(looked_.instants.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto by = [&](const VectorXd& measure) {
      std::ranges::stable_sort(order, std::ranges::greater{},
                               [&](std::size_t i) {
                                 return measure[static_cast<Index>(i)];
                               });
    };
    std::vector<std::size_t> solved;
    for (const bool by_stress : {true, false}) {
      by(by_stress ? stress : moved);
      std::size_t left = kMost;
      for (const std::size_t i : order) {
        const auto at = static_cast<Index>(i);
        const double bound = bound_at(i);
        const double peak = swing(i) * checked_peak(i, stress[at], largest);
        const bool may_count =
            bound > 1.0 &&
            (by_stress ? peak * bound > found.peak
                       : swing(i) * moved[at] * bound > found.deflection);
        if (!may_count || is_like_one(i, solved, part.coefficients())) continue;
        const double most = bound * (by_stress ? peak : swing(i) * moved[at]);
        if (left + kAlways <= kMost && !may_decide(by_stress, most)) continue;
        if (left == 0) {
          // those behind are bounded, not solved for
          if (by_stress) found.bound = std::max(found.bound, bound * peak);
          continue;
        }
        --left;
        solved.push_back(i);
        take(part, hold, i, stress[at], moved[at], largest, found);
        if (!found.is_stable) return;
      }
    }
  }

  /// Whether loads and spin of an instant that was solved for are the same.
  bool is_like_one(std::size_t i, const std::vector<std::size_t>& solved,
                   const MatrixXd& coefficients) const {
    constexpr double kAlike = 1e-3;
    const auto here = coefficients.col(static_cast<Index>(i));
    const Eigen::Vector3d& omega = looked_.instants[i].rigid.omega;
    return std::ranges::any_of(solved, [&](std::size_t k) {
      const auto there = coefficients.col(static_cast<Index>(k));
      return k == i || ((looked_.instants[k].rigid.omega - omega).norm() <=
                            kAlike * omega.norm() &&
                        (there - here).norm() <= kAlike * here.norm());
    });
  }

  /// Whether what rises to so much at most [Pa], [m] may be what a limit is
  /// exceeded by.
  bool may_decide(bool by_stress, double most) const {
    constexpr double kOfDegree = 1.05;
    const part::Limits& limits = job_.part.limits;
    if (!by_stress) {
      return limits.deflection && kOfDegree * most > *limits.deflection;
    }
    const PeakStress& peak = judged_peak(result_);
    const double allowed =
        job_.part.material.yield_strength / limits.safety_factor.value_or(1.0);
    return peak.band_low <= allowed &&
           most * peak.band_high > allowed * peak.value;
  }

  double swing(std::size_t i) const {
    return i < looked_.motion ? swing_ : 1.0;  // cases stand still
  }

  void take(const elasticity::SecondOrderPart& part, std::size_t hold,
            std::size_t i, double stress, double moved, double largest,
            SecondOrderResult& found) {
    const InstantLoad& instant = looked_.instants[i];
    const VectorXd all = part.coefficients().col(static_cast<Index>(i));
    const bool turns = common_ && i < looked_.motion;
    const auto answer =
        part.answer({.acting = turns ? *common_ : all,
                     .others = turns ? VectorXd(all - *common_)
                                     : VectorXd::Zero(all.size()),
                     .omega = instant.rigid.omega},
                    hold);
    found.is_known = true;
    if (!answer.is_stable) {
      found.is_stable = false;
      found.label = instant.label;
      return;
    }
    elasticity::DisplacementBasis<3> basis;
    basis.discretization = space_.whole;
    basis.columns = answer.displacement;
    basis.coefficients = MatrixXd::Ones(1, 1);
    const double rise =
        stress > 0.0 ? std::max(1.0, peaks(basis)[0] / stress) : 1.0;
    const double peak = swing(i) * rise * checked_peak(i, stress, largest);
    if (peak > found.peak) {
      found.peak = peak;
      found.stress = rise;
      found.label = instant.label;
    }
    const double now =
        swing(i) * std::max(moved, largest_displacement(answer.displacement));
    if (now > found.deflection) {
      found.deflection = now;
      found.deflection_rise = moved > 0.0 ? now / (swing(i) * moved) : 1.0;
    }
  }

  const PartJob& job_;
  const PartSpace& space_;
  const LoadSet& set_;
  const PartResult& result_;
  double swing_;
  Looked looked_;
  std::vector<InstantRow> rows_;
  Eigen::MatrixXi zone_of_;
  std::optional<VectorXd> common_;
};

/// Whether a part without this can be told of all the same.
bool is_bearable(const Error& error) {
  return error.code() == "F001" || error.code() == "F002" ||
         error.code() == "F004" || error.code() == "F007" ||
         error.code() == "M005";
}

/// Without a solution the buckling factor bounds what it would say.
void bound_by_factor(const Error& error, PartResult& result) {
  SecondOrderResult& found = result.second_order;
  result.notes.push_back(
      "how far its loads bend it further (second order) is not computed" +
      std::string(presses(result) ? ", but bounded by its buckling: " : ": ") +
      error.problem());
  if (!presses(result)) return;
  const double rise = rise_at(result.buckling.band_low);
  const double swing =
      result.swings.empty() ? 1.0 : std::ranges::max(result.swings);
  found.is_known = true;
  found.label = result.buckling.label;
  found.bound = std::max(found.bound, rise * swing * judged_peak(result).value);
  found.deflection = std::max(found.deflection, rise * result.deflection);
}

}  // namespace

void check_second_order(const PartJob& job, const std::vector<InstantRow>& rows,
                        PartResult& result) {
  std::optional<PartSpace> space;
  SecondOrderResult& found = result.second_order;
  for (std::size_t s = 0; s < job.load_sets.size() && found.is_stable; ++s) {
    try {
      if (looked_at(job, job.load_sets[s], result).instants.empty()) continue;
      if (!space) {
        const BucklingModel model(job);
        space = model.discretize(model.is_compact() ? 2 : 3);
        elasticity::require_dofs(space->whole.dofs(), job.max_dofs,
                                 "part " + job.part.name);
      }
      SetCheck(job, *space, s, rows, result).run(found);
    } catch (const Error& error) {
      if (!is_bearable(error)) throw;
      bound_by_factor(error, result);
      return;
    }
  }
  constexpr double kSays = 1.01;
  if (found.is_stable &&
      std::max(found.stress, found.deflection_rise) > kSays) {
    result.notes.push_back(fmt::format(
        "second order: loads act on what they displace, {:.4g} MPa at {} "
        "({:.3f} of linear theory's there), deflection {:.4g} mm ({:.3f}); the "
        "verdict has both, the table is of linear theory",
        1e-6 * found.peak, found.label, found.stress, 1e3 * found.deflection,
        found.deflection_rise));
  }
}

}  // namespace clevis::assessment
