#pragma once

#include <string>

#include "report/check/check_report.h"

namespace clevis::report {

/// Version of the format of result.json; grows when a key changes its meaning
/// or goes away, not when one is added.
inline constexpr int kResultSchema = 2;

/// The text of result.json (docs/result.schema.json, docs/results.md), also
/// what `clevis check --json` prints. Keys name their units.
/// @throws Error F003 if a number is not finite.
std::string result_json(const CheckReport& report);

}  // namespace clevis::report
