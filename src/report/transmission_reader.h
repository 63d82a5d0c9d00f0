#pragma once

#include <vector>

#include "report/json_node.h"
#include "report/result_reader.h"

namespace clevis::report {

/// What `clevis compare` looks at in a transmission.json: each transmission and
/// each of its elements. @throws Error I003.
std::vector<Subject> transmission_subjects(const JsonNode& document);

}  // namespace clevis::report
