#pragma once

#include <string_view>

#include "assessment/job/part_result.h"
#include "report/quantities/quantity.h"

namespace clevis::report {

/// Of a peak of von Mises' stress, without what follows from degree to degree.
const Quantities<assessment::PeakStress>& peak_quantities();

/// Of the nominal stress of a section that holds the part.
const Quantities<assessment::SupportStress>& section_quantities();

std::string_view text(assessment::PeakVerdict verdict);

}  // namespace clevis::report
