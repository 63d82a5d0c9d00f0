#pragma once

#include <optional>
#include <string>

#include "report/text/terminal.h"
#include "study/output.h"

namespace clevis::study {

/// The runs of all parts as a table, then per part what is fastest within
/// 1 % and 0.1 % of the peak.
std::string study_table(const Study& study, report::Colour colour);

/// The run of least processor time whose peak is within the tolerance, as are
/// all finer runs of its series after it: so that an error that crosses zero by
/// chance does not count. `is_clevis`: among clevis's forced models, or the
/// other programs. Nothing if there is none.
enum class Program { kClevis, kOther };
/// @param tolerance  of the peak, relative [1].
std::optional<Run> fastest_within(const PartStudy& part, double tolerance,
                                  Program program);

}  // namespace clevis::study
