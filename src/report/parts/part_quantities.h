#pragma once

#include "assessment/job/part_result.h"
#include "report/quantities/quantity.h"

namespace clevis::report {

/// Scalars of a part. A new one wants a row here; JSON, parts.csv and `clevis
/// compare` follow it.
const Quantities<assessment::PartResult>& part_quantities();

}  // namespace clevis::report
