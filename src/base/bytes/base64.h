#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clevis {

/// Base 64 of RFC 4648 with padding.
std::string base64(std::span<const std::byte> bytes);
/// The same behind what `text` holds; where it has room, nothing is copied.
void append_base64(std::span<const std::byte> bytes, std::string& text);
/// Characters that so many bytes take.
constexpr std::size_t base64_size(std::size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

/// The bytes of numbers as they stand in memory, little-endian, as base 64.
template <class Number>
std::string base64_of(const std::vector<Number>& numbers) {
  return base64(std::as_bytes(std::span(numbers)));
}

/// @throws Error I003 at `place` if the text is not base 64.
std::vector<std::byte> bytes_of_base64(std::string_view text,
                                       const std::string& place);

}  // namespace clevis
