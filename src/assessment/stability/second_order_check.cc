#include "assessment/stability/second_order_check.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "assessment/stability/buckling_model.h"
#include "assessment/vibration/load_pace.h"
#include "base/messages/errors.h"
#include "elasticity/buckling/second_order.h"
#include "elasticity/problem/dof_limit.h"
#include "loads/seats/holding_groups.h"

namespace clevis::assessment {
namespace {

using loads::InstantLoad;

/// That a label and a time mean; null: it is none of the set's.
const InstantLoad* find(const LoadSet& set, const std::string& label,
                        double time) {
  const auto& instants = set.history.instants;
  const auto found = std::ranges::find_if(instants, [&](const auto& instant) {
    return instant.label == label && instant.time == time;
  });
  return found == instants.end() ? nullptr : &*found;
}

/// At which the part spins fastest, if that is not slow beside its lowest
/// vibration; null: it is.
const InstantLoad* fastest(const PartJob& job, const LoadSet& set,
                           const PartResult& result) {
  constexpr double kSlow = 0.1;
  const auto& instants = set.history.instants;
  if (instants.empty()) return nullptr;
  const auto most =
      std::ranges::max_element(instants, {}, [](const InstantLoad& instant) {
        return instant.rigid.omega.norm();
      });
  const double turn = 2.0 * std::numbers::pi;
  const double period = result.first_period.value_or(longest_period(job, set));
  const bool is_slow = most->rigid.omega.norm() * period < kSlow * turn;
  return is_slow ? nullptr : &*most;
}

/// Instants of a set at which second order may count.
std::vector<InstantLoad> wanted(const PartJob& job, std::size_t s,
                                const PartResult& result) {
  constexpr double kFirstOrderIsEnough = 10.0;
  const LoadSet& set = job.load_sets[s];
  const BucklingResult& buckling = result.buckling;
  std::vector<const InstantLoad*> found;
  if (buckling.factor && buckling.band_low < kFirstOrderIsEnough) {
    const PeakStress& peak = judged_peak(result);
    if (buckling.load_set == s) {
      found.push_back(find(set, buckling.label, buckling.instant));
    }
    found.push_back(find(set, peak.label, peak.instant));
  }
  found.push_back(fastest(job, set, result));
  std::ranges::sort(found);
  const auto same = std::ranges::unique(found);
  found.erase(same.begin(), same.end());
  std::vector<InstantLoad> instants;
  for (const InstantLoad* instant : found) {
    if (instant != nullptr) instants.push_back(*instant);
  }
  return instants;
}

double largest_stress(const stress::InstantField& field) {
  double largest = 0.0;
  for (const auto& cell : field.stress) {
    largest = std::max(largest, stress::von_mises(cell).maxCoeff());
  }
  return largest;
}

double largest_displacement(const Eigen::VectorXd& u) {
  double largest = 0.0;
  for (Eigen::Index row = 0; row < u.size(); row += 3) {
    largest = std::max(largest, u.segment<3>(row).norm());
  }
  return largest;
}

/// Takes one instant with one hold in, if it rises more.
void take(const elasticity::SecondOrder& found, const InstantLoad& instant,
          const PartSpace& space, const PartJob& job,
          SecondOrderResult& result) {
  constexpr int kSubdivisions = 2;
  if (!found.is_stable) {
    result.is_stable = false;
    result.label = instant.label;
    return;
  }
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = space.whole;
  basis.columns.resize(found.linear.size(), 2);
  basis.columns << found.linear, found.second;
  basis.coefficients = Eigen::MatrixXd::Identity(2, 2);
  const auto stress_of = [&](int column) {
    return largest_stress(stress::instant_field<3>(basis, job.part.material,
                                                   kSubdivisions, column));
  };
  const double stress = stress_of(0);
  const double moved = largest_displacement(found.linear);
  if (stress > 0.0 && stress_of(1) / stress > result.stress) {
    result.stress = stress_of(1) / stress;
    if (result.is_stable) result.label = instant.label;
  }
  if (moved > 0.0) {
    result.deflection =
        std::max(result.deflection, largest_displacement(found.second) / moved);
  }
}

/// Whether a part without this can be told of all the same.
bool is_bearable(const Error& error) {
  return error.code() == "F001" || error.code() == "F002" ||
         error.code() == "F004" || error.code() == "F007" ||
         error.code() == "M005";
}

}  // namespace

void check_second_order(const PartJob& job, PartResult& result) {
  std::optional<BucklingModel> model;
  std::optional<PartSpace> space;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const LoadSet& set = job.load_sets[s];
    std::vector<InstantLoad> instants = wanted(job, s, result);
    if (instants.empty()) continue;
    try {
      if (!model) {
        model.emplace(job);
        space = model->discretize(model->is_compact() ? 2 : 3);
        elasticity::require_dofs(space->whole.dofs(), job.max_dofs,
                                 "part " + job.part.name);
      }
      loads::LoadHistory history = set.history;
      history.instants = std::move(instants);
      const auto holds = loads::holding_groups(set.history);
      for (const auto& found : elasticity::second_order(
               {space->whole, job.part.material, history, set.fixed, holds,
                job.part.name, set.foundations,
                space->plane ? &*space->plane : nullptr})) {
        take(found, history.instants[static_cast<std::size_t>(found.instant)],
             *space, job, result.second_order);
      }
    } catch (const Error& error) {
      if (!is_bearable(error)) throw;
      result.notes.push_back(
          "how far its loads bend it further (second order) is not computed: " +
          error.problem());
      return;
    }
  }
  constexpr double kSays = 1.01;
  const SecondOrderResult& found = result.second_order;
  if (found.is_stable && std::max(found.stress, found.deflection) > kSays) {
    result.notes.push_back(fmt::format(
        "second order ({}): its loads act on what they displace, stress rises "
        "to {:.3f} and deflection to {:.3f} of linear theory's; the verdict "
        "has both, the numbers are linear theory's",
        found.label, found.stress, found.deflection));
  }
}

}  // namespace clevis::assessment
