#pragma once

#include "assessment/job/part_result.h"
#include "report/quantities/quantity.h"

namespace clevis::report {

/// Of a stress or a displacement at a probe; keys of the other are left out.
const Quantities<assessment::ProbeResult>& probe_quantities();

/// Whether a probe's quantity is a displacement [m] rather than a stress [Pa].
bool is_displacement(const assessment::ProbeResult& probe);

}  // namespace clevis::report
