#pragma once

#include <cstddef>
#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Whether a case has probes, which want their values with every degree.
bool has_probes(const PartJob& job);

/// The governing instants of a part's load sets and their neighbours in time:
/// what the peak of a low degree is sought among.
class GoverningInstants {
 public:
  /// Empty where that saves nothing or a case has probes, which want their
  /// values with every degree.
  /// @param governing  instants of the job's sets, as governing_loads gives.
  GoverningInstants(const PartJob& job, const std::vector<LoadSet>& governing);

  /// One per load set that holds any; with the set's seats and supports.
  const std::vector<LoadSet>& sets() const { return sets_; }
  /// @param set  of the job; `instant` of this set.
  bool contains(std::size_t set, int instant) const;

 private:
  std::vector<LoadSet> sets_;
  std::vector<std::vector<bool>> chosen_;  ///< per set of the job and instant
};

}  // namespace clevis::assessment
