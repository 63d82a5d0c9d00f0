#include "stress/output/vtu_array.h"

#include <array>
#include <cstddef>
#include <cstdint>

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
  return fmt::format(
      "<DataArray type=\"{}\" {} format=\"binary\">\n{}{}\n</DataArray>\n",
      type, attributes, base64(std::as_bytes(std::span(head))), base64(packed));
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
