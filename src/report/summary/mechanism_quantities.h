#pragma once

#include "report/quantities/quantity.h"
#include "report/summary/mechanism_summary.h"

namespace clevis::report {

const Quantities<MechanismSummary>& mechanism_quantities();
const Quantities<JointPeaks>& joint_quantities();
/// Of a drive; keys of the other kind of effort are left out.
const Quantities<DrivePeak>& drive_quantities();

}  // namespace clevis::report
