#pragma once

#include <string>

#include "assessment/job/part_result.h"
#include "part/part_definition.h"

namespace clevis::assessment {

/// "0.3 % mesh + 0.1 % model", with time, contact and sharing where there are
/// any; of the peak.
std::string doubt_text(const PeakStress& peak);

/// Remedy for the largest of them: "give more instants" …
std::string doubt_remedy(const part::PartDefinition& part,
                         const ErrorShares& shares);

}  // namespace clevis::assessment
