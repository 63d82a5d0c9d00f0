#pragma once

#include <string>

#include "report/compare/comparison.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Moved quantities, a line each, and a line on the others.
std::string comparison_table(const Comparison& comparison, Colour colour);

/// One JSON document (docs/results.md) with what comparison_table() tells.
std::string comparison_json(const Comparison& comparison);

/// JUnit XML: one case per compared quantity.
std::string comparison_junit(const Comparison& comparison);

}  // namespace clevis::report
