#pragma once

#include <string>

#include "report/check/check_report.h"

namespace clevis::report {

/// The text of result.json (docs/result.schema.json, docs/results.md), also
/// what `clevis check --json` prints. Keys name their units.
/// @throws Error F003 if a number is not finite.
std::string result_json(const CheckReport& report);

}  // namespace clevis::report
