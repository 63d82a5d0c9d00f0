#pragma once

#include <optional>
#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// The peak and, where there is one, that away from the singular zones.
std::vector<PeakStress*> each_peak(PartResult& result);

/// That whose band reaches higher; absent if both are.
std::optional<SupportStress> larger(const std::optional<SupportStress>& one,
                                    const std::optional<SupportStress>& other);

/// Widens the judged peak's band by the model's error and says what has been
/// achieved.
/// @param tolerance, model_error  of the peak [1].
void add_model_error(double tolerance, double model_error, PartResult& result);

void add_seconds(const PartSeconds& earlier, PartSeconds& seconds);

/// Merges two assessments of one part: keeps that with the higher judged peak
/// and adds zones, deflection, probes and times of the other. A singular peak
/// of either one stays.
PartAssessment join(PartAssessment first, PartAssessment second);

}  // namespace clevis::assessment
