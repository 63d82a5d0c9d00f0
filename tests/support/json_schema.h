#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace clevis::test_support {

/// What `document` breaks of `schema`, one line each; empty: it is valid.
///
/// Knows the part of JSON Schema 2020-12 that docs/result.schema.json uses;
/// any other keyword is reported, so that a schema cannot demand what nobody
/// checks.
std::vector<std::string> schema_errors(const nlohmann::json& document,
                                       const nlohmann::json& schema);

}  // namespace clevis::test_support
