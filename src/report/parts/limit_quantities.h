#pragma once

#include "part/part_definition.h"
#include "report/quantities/quantity.h"

namespace clevis::report {

/// Of a part's limits, as the user wrote them; null: not given.
const Quantities<part::Limits>& limit_quantities();

}  // namespace clevis::report
