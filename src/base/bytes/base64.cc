#include "base/bytes/base64.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "base/messages/errors.h"

namespace clevis {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the files hold little-endian numbers");

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::array<int, 256> digit_values() {
  std::array<int, 256> values{};
  values.fill(-1);
  for (std::size_t d = 0; d < kDigits.size(); ++d) {
    values[static_cast<unsigned char>(kDigits[d])] = static_cast<int>(d);
  }
  return values;
}

}  // namespace

std::string base64(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 |
             (k < here ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= here ? kDigits[bits >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::vector<std::byte> bytes_of_base64(std::string_view text,
                                       const std::string& place) {
  static const auto kValues = digit_values();
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() * 3 / 4);
  std::uint32_t bits = 0;
  int known = 0;
  for (const char digit : text) {
    const int value = kValues[static_cast<unsigned char>(digit)];
    if (value < 0) {
      throw Error("I003", place, "the text is not base 64",
                  "Run `clevis check` again.");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    known += 6;
    if (known < 8) continue;
    known -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> known & 255U));
  }
  return bytes;
}

}  // namespace clevis
