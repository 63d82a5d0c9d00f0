#pragma once

#include <vector>

#include "report/compare/stored_result.h"
#include "report/text/json_node.h"

namespace clevis::report {

/// What `clevis compare` holds of a part's blows, their models and its
/// vibration; nothing where there are none.
/// @param part  of a result.json's parts.
/// @throws Error I003.
std::vector<Subject> impact_subjects(const JsonNode& part);

/// Its held section: adds `section_stress` and its band.
/// @param holder  a part or one of its blows.
void add_held_section(const JsonNode& holder, Subject& subject);

}  // namespace clevis::report
