#pragma once

#include <string>

namespace clevis::report {

/// A field of RFC 4180 text: quoted where it holds a separator.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

}  // namespace clevis::report
