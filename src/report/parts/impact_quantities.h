#pragma once

#include "assessment/job/part_result.h"
#include "report/quantities/quantity.h"

namespace clevis::report {

/// Of a blow on a part.
const Quantities<assessment::ImpactResult>& blow_quantities();

/// Of what one model says of a blow.
const Quantities<assessment::ImpactRow>& blow_model_quantities();

/// Of an impact of the mechanism as it loads a part.
const Quantities<assessment::DurationRatio>& duration_ratio_quantities();

/// Of a part's vibration that was computed.
const Quantities<assessment::VibrationResult>& vibration_quantities();

/// The blow that leaves the part the least safety; null without blows.
const assessment::ImpactResult* governing_blow(
    const assessment::PartResult& part);

/// Null where the loads of the instants suffice or it could not be computed.
const assessment::VibrationResult* computed_vibration(
    const assessment::PartResult& part);

}  // namespace clevis::report
