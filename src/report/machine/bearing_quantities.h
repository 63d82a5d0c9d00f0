#pragma once

#include "report/machine/bearing_report.h"
#include "report/quantities/quantity.h"

namespace clevis::report {

/// Scalars of a bearing; a life or safety without bound is not known.
const Quantities<BearingReport>& bearing_quantities();

}  // namespace clevis::report
