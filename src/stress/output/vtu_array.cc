#include "stress/output/vtu_array.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <new>

#include <fmt/format.h>
#include <zlib.h>

namespace clevis::stress {
namespace {

using Bytes = std::span<const unsigned char>;

void append_base64(Bytes bytes, std::string& text) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t begin = text.size();
  text.resize(begin + (bytes.size() + 2) / 3 * 4, '=');
  char* to = text.data() + begin;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < left ? bytes[i + k] : 0U);
    }
    for (std::size_t k = 0; k <= left; ++k) {
      to[k] = kDigits[group >> (18 - 6 * k) & 63U];
    }
    to += 4;
  }
}

/// @param type  VTK's name.
std::string array_of(Bytes bytes, const char* type,
                     const std::string& attributes) {
  std::vector<unsigned char> packed(
      compressBound(static_cast<uLong>(bytes.size())));
  auto size = static_cast<uLongf>(packed.size());
  // It fails only if there is no memory or the bound does not hold.
  if (compress2(packed.data(), &size, bytes.data(),
                static_cast<uLong>(bytes.size()), Z_BEST_SPEED) != Z_OK) {
    throw std::bad_alloc();
  }
  // Blocks, their size, that of the last, and what each is packed to.
  const std::array<std::uint32_t, 4> head = {
      1, static_cast<std::uint32_t>(bytes.size()),
      static_cast<std::uint32_t>(bytes.size()),
      static_cast<std::uint32_t>(size)};
  std::array<unsigned char, sizeof head> head_bytes{};
  std::memcpy(head_bytes.data(), head.data(), sizeof head);
  std::string text = fmt::format(
      "<DataArray type=\"{}\" {} format=\"binary\">\n", type, attributes);
  append_base64(head_bytes, text);
  append_base64(Bytes(packed.data(), size), text);
  return text + "\n</DataArray>\n";
}

template <class Value>
Bytes bytes_of(std::span<const Value> values) {
  return {reinterpret_cast<const unsigned char*>(values.data()),
          values.size_bytes()};
}

}  // namespace

std::string vtu_array(std::span<const float> values,
                      const std::string& attributes) {
  return array_of(bytes_of(values), "Float32", attributes);
}

std::string vtu_array(std::span<const std::int32_t> values,
                      const std::string& attributes) {
  return array_of(bytes_of(values), "Int32", attributes);
}

std::string vtu_array(std::span<const std::uint8_t> values,
                      const std::string& attributes) {
  return array_of(bytes_of(values), "UInt8", attributes);
}

}  // namespace clevis::stress
