#include "assessment/ladder/governing_instants.h"

#include <algorithm>

namespace clevis::assessment {
namespace {

bool is_same(const loads::InstantLoad& a, const loads::InstantLoad& b) {
  return a.label == b.label && a.time == b.time;
}

/// The instants of a set that are among the governing ones or near to one.
std::vector<bool> choose(const std::vector<loads::InstantLoad>& instants,
                         const std::vector<LoadSet>& governing) {
  constexpr std::size_t kNeighbours = 3;
  std::vector<bool> chosen(instants.size(), false);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const bool governs = std::ranges::any_of(governing, [&](const auto& set) {
      return std::ranges::any_of(set.history.instants, [&](const auto& other) {
        return is_same(instants[i], other);
      });
    });
    if (!governs) continue;
    const std::size_t begin = i - std::min(i, kNeighbours);
    const std::size_t end = std::min(instants.size(), i + kNeighbours + 1);
    for (std::size_t k = begin; k < end; ++k) chosen[k] = true;
  }
  return chosen;
}

}  // namespace

bool has_probes(const PartJob& job) {
  return std::ranges::any_of(job.part.cases, [](const auto& load_case) {
    return !load_case.probes.empty();
  });
}

GoverningInstants::GoverningInstants(const PartJob& job,
                                     const std::vector<LoadSet>& governing) {
  if (governing.empty() || has_probes(job)) return;
  std::size_t all = 0;
  std::size_t kept = 0;
  for (const LoadSet& set : job.load_sets) {
    chosen_.push_back(choose(set.history.instants, governing));
    LoadSet few = set;
    few.history.instants.clear();
    for (std::size_t i = 0; i < set.history.instants.size(); ++i) {
      if (!chosen_.back()[i]) continue;
      few.history.instants.push_back(set.history.instants[i]);
    }
    all += set.history.instants.size();
    kept += few.history.instants.size();
    if (!few.history.instants.empty()) sets_.push_back(std::move(few));
  }
  if (2 * kept > all) sets_.clear();
}

bool GoverningInstants::contains(std::size_t set, int instant) const {
  return chosen_[set][static_cast<std::size_t>(instant)];
}

}  // namespace clevis::assessment
