#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace clevis::report {

/// Version of the JSON documents that clevis writes, `schema` in each: grows
/// when a key goes away or changes its meaning.
inline constexpr int kSchema = 2;

/// Refuses numbers that JSON cannot hold, before they would become `null`.
/// @throws Error F003 that names the first NaN or Inf, at `place`.
void refuse_non_finite(const nlohmann::ordered_json& document,
                       const std::string& place);

/// Pretty text with a final newline. Doubles are written with the fewest
/// digits that read back to the same bits; invalid UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& document);

/// The text itself if it is UTF-8, else with U+FFFD in the place of what is
/// not: group names of a mesh may hold any bytes.
std::string valid_utf8(const std::string& text);

/// @throws Error I001 if the file cannot be read, I003 with line and column
///   if it is not JSON.
nlohmann::ordered_json read_json(const std::filesystem::path& file);

}  // namespace clevis::report
