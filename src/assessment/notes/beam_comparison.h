#pragma once

#include <string>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Beam and lug theory from the loads that the FE took, beside its result.
/// @param result  with its peak.
BeamComparison compare_with_beam(const PartJob& job, const PartResult& result);

/// Why the FE peak leaves 0.8–1.25 of the beam's; empty if it does not.
std::string explain_ratio(const PeakStress& peak, const BeamComparison& beam);

}  // namespace clevis::assessment
