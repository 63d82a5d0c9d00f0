#include "stress/output/vtu_array.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "base/bytes/base64.h"
#include "base/bytes/compression.h"

namespace clevis::stress {
namespace {

/// @param type  VTK's name.
std::string array_of(std::span<const std::byte> bytes, const char* type,
                     const std::string& attributes) {
  const auto packed = compressed(bytes, Effort::kFast);
  // Blocks, their size, that of the last, and what each is packed to.
  const std::array<std::uint32_t, 4> head = {
      1, static_cast<std::uint32_t>(bytes.size()),
      static_cast<std::uint32_t>(bytes.size()),
      static_cast<std::uint32_t>(packed.size())};
  std::string text =
      fmt::format("<DataArray type=\"{}\" {} format=\"binary\">\n{}", type,
                  attributes, base64(std::as_bytes(std::span(head))));
  constexpr std::string_view kEnd = "\n</DataArray>\n";
  text.reserve(text.size() + base64_size(packed.size()) + kEnd.size());
  append_base64(packed, text);
  return text.append(kEnd);
}

}  // namespace

std::string vtu_array(std::span<const float> values,
                      const std::string& attributes) {
  return array_of(std::as_bytes(values), "Float32", attributes);
}

std::string vtu_array(std::span<const std::int32_t> values,
                      const std::string& attributes) {
  return array_of(std::as_bytes(values), "Int32", attributes);
}

std::string vtu_array(std::span<const std::uint8_t> values,
                      const std::string& attributes) {
  return array_of(std::as_bytes(values), "UInt8", attributes);
}

}  // namespace clevis::stress
