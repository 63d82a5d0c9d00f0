#pragma once

#include <vector>

#include "report/compare/stored_result.h"
#include "report/text/json_node.h"

namespace clevis::report {

/// What `clevis compare` looks at in a transmission.json: each transmission and
/// each of its elements. @throws Error I003.
std::vector<Subject> transmission_subjects(const JsonNode& document);

}  // namespace clevis::report
