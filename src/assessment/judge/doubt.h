#pragma once

#include <string>

#include "assessment/job/part_result.h"
#include "part/part_definition.h"

namespace clevis::assessment {

/// "0.3 % mesh + 0.1 % model", with time, contact and sharing where there are
/// any; of the peak.
std::string doubt_text(const PeakStress& peak);

/// Widens the band both ways by what cells may not show, which counts as the
/// mesh's; beyond the tolerance the peak has not converged.
/// @param amount  [Pa].
void widen_for_cells(PeakStress& peak, double amount, double tolerance);

/// Whether the largest of them is one that a smaller tolerance narrows: of the
/// mesh or the model.
bool is_of_tolerance(const ErrorShares& shares);

/// Remedy for the largest of them: "give more instants" …
std::string doubt_remedy(const part::PartDefinition& part,
                         const ErrorShares& shares);

}  // namespace clevis::assessment
