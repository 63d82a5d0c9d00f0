#include "assessment/ladder/load_accuracy.h"

#include <algorithm>

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Stress and displacement over their largest, by an error of the load over the
/// largest load: what is left out varies quickly along the walls.
constexpr double kOfLoad = 3.0;

/// Of load sets with fewer instants no columns are saved to speak of.
constexpr std::size_t kFew = 40;

double admitted_of(const PartJob& job) {
  constexpr double kShare = 0.01;
  return kShare * job.tolerance;
}

bool wants_all_exactly(const PartJob& job) {
  return has_probes(job) ||
         std::ranges::all_of(job.load_sets, [](const auto& set) {
           return set.history.instants.size() < kFew;
         });
}

}  // namespace

template <int dim>
std::vector<VectorXd> admitted_load_errors(const PartJob& job,
                                           const Level<dim>& before) {
  constexpr double kNear = 0.9;
  if (wants_all_exactly(job)) return {};
  double peak = 0.0, deflection = 0.0;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    peak = std::max(peak, before.histories[s].peak.maxCoeff());
    deflection = std::max(deflection, before.deflections[s].value);
  }
  std::vector<VectorXd> admitted;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const auto governs =
        before.histories[s].peak.array() >= kNear * peak ||
        before.deflections[s].of_instant.array() >= kNear * deflection;
    admitted.push_back(
        governs.select(VectorXd::Zero(before.histories[s].peak.size()).array(),
                       admitted_of(job)));
  }
  return admitted;
}

std::vector<VectorXd> admitted_load_errors(const PartJob& job,
                                           const GoverningInstants& chosen) {
  if (wants_all_exactly(job)) return {};
  std::vector<VectorXd> admitted;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const std::size_t instants = job.load_sets[s].history.instants.size();
    VectorXd& of_set = admitted.emplace_back(
        VectorXd::Constant(static_cast<Index>(instants), admitted_of(job)));
    for (std::size_t i = 0; i < instants; ++i) {
      if (chosen.contains(s, static_cast<int>(i))) {
        of_set[static_cast<Index>(i)] = 0.0;
      }
    }
  }
  return admitted;
}

template <int dim>
bool peak_is_inexact(const Level<dim>& level) {
  return !level.admitted.empty() &&
         level.admitted[level.set][level.history().peak_instant] > 0.0;
}

template <int dim>
double rise_of_inexact(const Level<dim>& level) {
  const double largest = level.history().largest();
  double highest = largest;
  for (std::size_t s = 0; s < level.admitted.size(); ++s) {
    const VectorXd& admitted = level.admitted[s];
    const VectorXd& peak = level.histories[s].peak;
    for (Index i = 0; i < admitted.size(); ++i) {
      if (admitted[i] == 0.0) continue;
      highest = std::max(highest, peak[i] + kOfLoad * admitted[i] * largest);
    }
  }
  return highest - largest;
}

template <int dim>
double inexact_deflection(const Level<dim>& level, std::size_t set) {
  return level.admitted.empty() ? 0.0
                                : kOfLoad * level.admitted[set].maxCoeff();
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template std::vector<VectorXd> admitted_load_errors<dim>(const PartJob&,     \
                                                           const Level<dim>&); \
  template bool peak_is_inexact<dim>(const Level<dim>&);                       \
  template double rise_of_inexact<dim>(const Level<dim>&);                     \
  template double inexact_deflection<dim>(const Level<dim>&, std::size_t);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::assessment
