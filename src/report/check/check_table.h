#pragma once

#include <string>

#include "report/check/check_report.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Table of `clevis check`: one line per part, below it the reasons of a
/// verdict or of a ratio that needs one, last the overall verdict.
std::string check_table(const CheckReport& report, Colour colour);

}  // namespace clevis::report
