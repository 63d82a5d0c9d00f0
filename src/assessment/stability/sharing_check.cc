#include "assessment/stability/sharing_check.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "assessment/models/level.h"
#include "assessment/models/model_list.h"
#include "elasticity/problem/displacement_basis.h"
#include "loads/history/balance.h"
#include "stress/field/deflection.h"
#include "stress/field/stress_history.h"
#include "stress/zones/singular_zone.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kSubdivisions = 4;
constexpr int kPlaneDegree = 3;
constexpr int kDegree = 2;
constexpr int kTerms = 3;

/// Per instant, away from all singular zones.
struct Answers {
  VectorXd stress;      ///< largest von Mises [Pa]
  VectorXd deflection;  ///< largest [m]
};

template <int dim>
VectorXd deflections(elasticity::DisplacementBasis<dim> basis,
                     const LoadSet& set) {
  if (set.fixed.empty() && set.foundations.empty()) {
    stress::remove_rigid_motion<dim>(basis, reference_groups(set));
  }
  VectorXd largest(basis.coefficients.cols());
  for (Index i = 0; i < largest.size(); ++i) {
    const VectorXd u = basis.columns * basis.coefficients.col(i);
    largest[i] = u.reshaped(dim, u.size() / dim).colwise().norm().maxCoeff();
  }
  return largest;
}

template <int dim>
Answers answers_of(const PartJob& job, const LoadSet& set,
                   const std::vector<stress::SingularZone>& zones,
                   const elasticity::DisplacementBasis<dim>& basis) {
  const auto zone_of =
      stress::zone_of_points<dim>(basis.discretization, kSubdivisions, zones);
  return {stress::peaks_outside<dim>(basis, job.part.material, kSubdivisions,
                                     zone_of),
          deflections<dim>(basis, set)};
}

/// By the cheapest model that suits the loads and is quick to look at.
Answers rough_answers(const PartJob& job, const LoadSet& set) {
  PartJob alone;
  alone.part = job.part;
  alone.mesh = job.mesh;
  alone.load_sets = {set};
  alone.engine = job.engine;
  alone.is_shared = job.is_shared;
  const PartShape shape(alone);
  const auto answers = [&]<int dim>(const FeModel<dim>& model) {
    const auto basis = model.solve({.mesh = *model.mesh,
                                    .material = job.part.material,
                                    .history = set.history,
                                    .fixed = set.fixed,
                                    .name = job.part.name,
                                    .foundations = set.foundations,
                                    .engine = job.engine,
                                    .is_shared = job.is_shared},
                                   dim == 2 ? kPlaneDegree : kDegree);
    return answers_of<dim>(job, set, model.zones(set), basis);
  };
  return std::visit(answers, cheapest_for_many_instants(shape).make(
                                 shape, {.terms = kTerms}));
}

/// Of one sharing: largest over its instants.
struct Largest {
  double stress{}, deflection{};
};

Largest largest_of(const Answers& answers, Index first, Index count) {
  if (count == 0) return {};
  return {answers.stress.segment(first, count).maxCoeff(),
          answers.deflection.segment(first, count).maxCoeff()};
}

double load_of(const loads::InstantLoad& instant, double size) {
  double sum = 0.0;
  for (const auto& wrench : instant.wrenches) {
    sum += wrench.force.norm() + wrench.moment.norm() / size;
  }
  return sum;
}

/// The instants that carry most.
loads::LoadHistory heaviest(loads::LoadHistory history, std::size_t most,
                            double size) {
  auto& instants = history.instants;
  if (instants.size() <= most) return history;
  std::ranges::nth_element(instants,
                           instants.begin() + static_cast<std::ptrdiff_t>(most),
                           [&](const auto& a, const auto& b) {
                             return load_of(a, size) > load_of(b, size);
                           });
  instants.resize(most);
  return history;
}

constexpr std::size_t kMostInstants = 1000, kFewest = 20;

/// So many instants of each sharing are looked at.
std::size_t most_of_each(const OpenSharing& sharing) {
  return std::max(kFewest, kMostInstants / (sharing.others.size() + 1));
}

/// The sharing that was checked first, then the others.
std::vector<Largest> compare(const PartJob& job, const OpenSharing& sharing) {
  const double size = loads::part_size(job.groups, job.mass);
  const std::size_t most = most_of_each(sharing);
  LoadSet set = job.load_sets[sharing.set];
  set.history = heaviest(sharing.checked, most, size);
  std::vector<std::size_t> counts{set.history.instants.size()};
  for (const loads::LoadHistory& other : sharing.others) {
    const auto instants = heaviest(other, most, size).instants;
    counts.push_back(instants.size());
    set.history.instants.insert(set.history.instants.end(), instants.begin(),
                                instants.end());
  }
  const Answers answers = rough_answers(job, set);
  std::vector<Largest> result;
  Index first = 0;
  for (const std::size_t count : counts) {
    result.push_back(largest_of(answers, first, static_cast<Index>(count)));
    first += static_cast<Index>(count);
  }
  return result;
}

/// Factors on what was checked.
struct Factors {
  double low = 1.0, high = 1.0;
};

/// @param fixed  what does not depend on the sharing.
Factors factors_of(const std::vector<Largest>& sharings, double fixed,
                   double Largest::*value, double margin) {
  const double checked = std::max(fixed, sharings.front().*value);
  Factors factors;
  if (!(checked > 0.0)) return factors;
  for (const Largest& sharing : sharings) {
    const double ratio = std::max(fixed, sharing.*value) / checked;
    factors.low = std::min(factors.low, ratio);
    factors.high = std::max(factors.high, ratio);
  }
  factors.low = std::max(0.0, 1.0 + margin * (factors.low - 1.0));
  factors.high = 1.0 + margin * (factors.high - 1.0);
  return factors;
}

void widen(const Factors& factors, PeakStress& peak) {
  peak.shares.sharing +=
      peak.value * std::max(factors.high - 1.0, 1.0 - factors.low);
  peak.band_low *= factors.low;
  peak.band_high *= factors.high;
}

void widen(const Factors& stress, const Factors& deflection,
           PartResult& result) {
  widen(stress, result.peak);
  if (result.peak_outside) widen(stress, *result.peak_outside);
  result.finite_motion.rotation *= deflection.high;
  result.finite_motion.strain *= stress.high;
  result.vibration.band_low *= stress.low;
  result.vibration.band_high *= stress.high;
  if (result.deflection_high == 0.0) {
    result.deflection_low = result.deflection_high = result.deflection;
  }
  result.deflection_low *= deflection.low;
  result.deflection_high *= deflection.high;
}

/// Solution for the loads of a part as they were checked, once per load set.
class CheckedAnswers {
 public:
  explicit CheckedAnswers(const PartJob& job)
      : job_(job), of_sets_(job.load_sets.size()) {}

  /// Of all loads but the shared ones, which no sharing changes.
  Largest besides(const OpenSharing& sharing) {
    std::set<std::string> shared;
    for (const auto& instant : sharing.checked.instants) {
      shared.insert(instant.label);
    }
    Largest largest;
    for (std::size_t s = 0; s < of_sets_.size(); ++s) {
      const auto& instants = job_.load_sets[s].history.instants;
      for (std::size_t i = 0; i < instants.size(); ++i) {
        if (s == sharing.set && shared.contains(instants[i].label)) continue;
        const auto at = static_cast<Index>(i);
        const Answers& answers = of_set(s);
        largest.stress = std::max(largest.stress, answers.stress[at]);
        largest.deflection =
            std::max(largest.deflection, answers.deflection[at]);
      }
    }
    return largest;
  }

 private:
  const Answers& of_set(std::size_t s) {
    auto& answers = of_sets_[s];
    if (!answers) answers = rough_answers(job_, job_.load_sets[s]);
    return *answers;
  }

  const PartJob& job_;
  std::vector<std::optional<Answers>> of_sets_;
};

}  // namespace

std::vector<loads::InstantLoad> heaviest_of_others(const PartJob& job,
                                                   const OpenSharing& sharing) {
  const double size = loads::part_size(job.groups, job.mass);
  std::vector<loads::InstantLoad> all;
  for (const loads::LoadHistory& other : sharing.others) {
    const auto instants = heaviest(other, most_of_each(sharing), size).instants;
    all.insert(all.end(), instants.begin(), instants.end());
  }
  return all;
}

void check_sharing(const PartJob& job, PartResult& result) {
  constexpr double kMarginOfSome = 1.5;  // where not all corners were tried
  constexpr double kTold = 1e-3;
  CheckedAnswers checked(job);
  for (const OpenSharing& sharing : job.open_sharings) {
    if (sharing.others.empty()) continue;
    const auto sharings = compare(job, sharing);
    const Largest fixed = checked.besides(sharing);
    const double margin = sharing.is_complete ? 1.0 : kMarginOfSome;
    const Factors stress =
        factors_of(sharings, fixed.stress, &Largest::stress, margin);
    const Factors deflection =
        factors_of(sharings, fixed.deflection, &Largest::deflection, margin);
    widen(stress, deflection, result);
    if (stress.high - stress.low < kTold) continue;
    result.notes.push_back(fmt::format(
        "reactions that equilibrium leaves open may be shared otherwise: the "
        "peak is {:.4g} to {:.4g} times the one printed; {}",
        stress.low, stress.high, sharing.remedy));
  }
}

}  // namespace clevis::assessment
