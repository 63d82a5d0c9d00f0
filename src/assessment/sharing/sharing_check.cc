#include "assessment/sharing/sharing_check.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "assessment/sharing/least_sharing.h"
#include "assessment/sharing/rough_answers.h"
#include "loads/history/balance.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;

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

/// The sharing that was checked first, then the others; last, where they
/// differ, the least that any between them was found to reach.
std::vector<RoughPeak> compare(const PartJob& job, const OpenSharing& sharing) {
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
  const RoughAnswers answers = rough_answers(job, set);
  std::vector<RoughPeak> result;
  Index first = 0;
  for (const std::size_t count : counts) {
    result.push_back(largest_of(answers, first, static_cast<Index>(count)));
    first += static_cast<Index>(count);
  }
  constexpr double kAlike = 1e-3;
  const auto differ = [&](double RoughPeak::*measure) {
    const auto [low, high] = std::ranges::minmax(result, {}, measure);
    return high.*measure - low.*measure > kAlike * high.*measure;
  };
  if (differ(&RoughPeak::stress) || differ(&RoughPeak::deflection)) {
    result.push_back(least_sharing(job, sharing));
  }
  return result;
}

/// Factors on what was checked.
struct Factors {
  double low = 1.0, high = 1.0;
};

/// @param fixed  what does not depend on the sharing.
Factors factors_of(const std::vector<RoughPeak>& sharings, double fixed,
                   double RoughPeak::*value, double margin) {
  const double checked = std::max(fixed, sharings.front().*value);
  Factors factors;
  if (!(checked > 0.0)) return factors;
  for (const RoughPeak& sharing : sharings) {
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
  RoughPeak besides(const OpenSharing& sharing) {
    std::set<std::string> shared;
    for (const auto& instant : sharing.checked.instants) {
      shared.insert(instant.label);
    }
    RoughPeak largest;
    for (std::size_t s = 0; s < of_sets_.size(); ++s) {
      const auto& instants = job_.load_sets[s].history.instants;
      for (std::size_t i = 0; i < instants.size(); ++i) {
        if (s == sharing.set && shared.contains(instants[i].label)) continue;
        const auto at = static_cast<Index>(i);
        const RoughAnswers& answers = of_set(s);
        largest.stress = std::max(largest.stress, answers.stress[at]);
        largest.deflection =
            std::max(largest.deflection, answers.deflection[at]);
      }
    }
    return largest;
  }

 private:
  const RoughAnswers& of_set(std::size_t s) {
    auto& answers = of_sets_[s];
    if (!answers) answers = rough_answers(job_, job_.load_sets[s]);
    return *answers;
  }

  const PartJob& job_;
  std::vector<std::optional<RoughAnswers>> of_sets_;
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
    const RoughPeak fixed = checked.besides(sharing);
    const double margin = sharing.is_complete ? 1.0 : kMarginOfSome;
    const Factors stress =
        factors_of(sharings, fixed.stress, &RoughPeak::stress, margin);
    const Factors deflection =
        factors_of(sharings, fixed.deflection, &RoughPeak::deflection, margin);
    widen(stress, deflection, result);
    if (stress.high - stress.low < kTold) continue;
    result.notes.push_back(fmt::format(
        "reactions that equilibrium leaves open may be shared otherwise: the "
        "peak is {:.4g} to {:.4g} times the one printed; {}",
        stress.low, stress.high, sharing.remedy));
  }
}

}  // namespace clevis::assessment
