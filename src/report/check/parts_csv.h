#pragma once

#include <string>

#include "report/check/check_report.h"

namespace clevis::report {

/// The parts as RFC 4180 text (CRLF, quotes where needed): one row per part,
/// units in the header, every number to the digits that read back the same.
std::string parts_csv(const CheckReport& report);

}  // namespace clevis::report
