#pragma once

#include <string>

#include "report/check/check_report.h"

namespace clevis::report {

/// junit.xml of a check: per part the cases "convergence", "safety factor"
/// and "deflection", so that a CI page shows what broke and by how much.
///
/// A limit that is exceeded is a failure; a peak that did not settle, a part
/// that is not judged or could not be computed is an error; a limit that the
/// scene does not set is skipped. A verdict that none of the three explains
/// gets a fourth case "verdict": the file never looks better than the table.
std::string check_junit(const CheckReport& report);

}  // namespace clevis::report
