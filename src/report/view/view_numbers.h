#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/bytes/base64.h"

namespace clevis::report {

/// Numbers in base 64 with what they are: "f32", "i8", "i16", "u16" or "u32",
/// little-endian.
inline nlohmann::ordered_json packed(const std::vector<float>& numbers) {
  return {{"type", "f32"}, {"base64", base64_of(numbers)}};
}

/// Positions in a list, in 16 bits where they fit.
inline nlohmann::ordered_json packed(
    const std::vector<std::uint32_t>& numbers) {
  std::vector<std::uint16_t> narrow;
  for (const std::uint32_t number : numbers) {
    if (number > std::numeric_limits<std::uint16_t>::max()) {
      return {{"type", "u32"}, {"base64", base64_of(numbers)}};
    }
    narrow.push_back(static_cast<std::uint16_t>(number));
  }
  return {{"type", "u16"}, {"base64", base64_of(narrow)}};
}

inline nlohmann::ordered_json packed(const std::vector<std::int8_t>& numbers) {
  return {{"type", "i8"}, {"base64", base64_of(numbers)}};
}

inline nlohmann::ordered_json packed(const std::vector<std::int16_t>& numbers) {
  return {{"type", "i16"}, {"base64", base64_of(numbers)}};
}

}  // namespace clevis::report
