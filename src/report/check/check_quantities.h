#pragma once

#include "report/check/check_report.h"
#include "report/quantities/quantity.h"

namespace clevis::report {

/// Scalars of a check as a whole.
const Quantities<CheckReport>& check_quantities();

}  // namespace clevis::report
