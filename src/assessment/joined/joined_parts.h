#pragma once

#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/job/part_result.h"

namespace clevis::assessment {

/// Parts of a mechanism that yield together, by their names.
struct JoinedParts {
  /// Their bodies hang together without the ground.
  std::vector<std::vector<std::string>> moving;
  /// Welds or joints that drives fix hand all moments on among them.
  std::vector<std::vector<std::string>> stiffly;
  /// By these, and by force elements that hold what joints and drives leave.
  std::vector<std::vector<std::string>> elastically;
};

/// Doubts parts for what the others yield: each is checked with the rest of the
/// mechanism rigid. Of compliances that add up first frequencies f and factors
/// λ of buckling are at least those of
///
///     1/f² = Σ 1/fᵢ²,  1/λ = Σ 1/λᵢ,
///
/// i over the parts, each alone soft (Dunkerley, Southwell). Where a load meets
/// a part between its own frequency and that, its vibration is not known; the
/// factor of buckling and what it makes of stress in second order go into their
/// bands. Verdicts are given anew.
///
/// Source: [TimoshenkoGere].
/// @param results  of the parts that were checked, in any order.
/// @return names of parts whose verdict has changed.
std::vector<std::string> doubt_by_joined(const std::vector<PartJob>& jobs,
                                         const JoinedParts& joined,
                                         std::vector<PartResult>& results);

}  // namespace clevis::assessment
