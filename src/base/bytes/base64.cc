#include "base/bytes/base64.h"

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
  append_base64(bytes, text);
  return text;
}

void append_base64(std::span<const std::byte> bytes, std::string& text) {
  const std::size_t begin = text.size();
  text.resize(begin + base64_size(bytes.size()), '=');
  char* to = text.data() + begin;
  const auto put = [&to](std::uint32_t bits, int digits) {
    for (int k = 0; k < digits; ++k)
      to[k] = kDigits[bits >> (18 - 6 * k) & 63U];
    to += 4;
  };
  const auto byte = [&](std::size_t i) {
    return std::to_integer<std::uint32_t>(bytes[i]);
  };
  std::size_t i = 0;
  for (; i + 3 <= bytes.size(); i += 3) {
    put(byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2), 4);
  }
  if (bytes.size() - i == 1) put(byte(i) << 16, 2);
  if (bytes.size() - i == 2) put(byte(i) << 16 | byte(i + 1) << 8, 3);
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
