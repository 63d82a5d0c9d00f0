#pragma once

#include <vector>

#include "report/compare/stored_result.h"
#include "report/text/json_node.h"

namespace clevis::report {

/// Quantities of a transmission.json for `clevis compare`: each transmission
/// and each of its elements. @throws Error I003.
std::vector<Subject> transmission_subjects(const JsonNode& document);

}  // namespace clevis::report
