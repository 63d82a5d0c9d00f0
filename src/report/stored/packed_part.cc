#include "report/stored/packed_part.h"

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "base/bytes/base64.h"
#include "report/stored/stored_numbers.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

/// How far below the next new number each is; empty if one is above it.
template <class Number>
std::vector<Number> firsts(const std::vector<Number>& numbers) {
  std::vector<Number> codes;
  std::uint64_t next = 0;
  for (const Number number : numbers) {
    if (number > next) return {};
    codes.push_back(static_cast<Number>(next - number));
    if (number == next) ++next;
  }
  return codes;
}

/// Differences, signs folded into the lowest bit; of the numbers' own width.
template <class Number>
std::vector<Number> steps(const std::vector<Number>& numbers) {
  using Unsigned = std::make_unsigned_t<Number>;
  using Signed = std::make_signed_t<Number>;
  std::vector<Number> codes;
  Unsigned before = 0;
  for (const Number number : numbers) {
    const auto now = static_cast<Unsigned>(number);
    const auto step = static_cast<Signed>(static_cast<Unsigned>(now - before));
    const auto doubled =
        static_cast<Unsigned>(static_cast<Unsigned>(step) << 1U);
    codes.push_back(static_cast<Number>(
        step < 0 ? static_cast<Unsigned>(~doubled) : doubled));
    before = now;
  }
  return codes;
}

template <class Number>
void append_planes(const std::vector<Number>& numbers,
                   std::vector<std::byte>& bytes) {
  const auto whole = std::as_bytes(std::span(numbers));
  for (std::size_t plane = 0; plane < sizeof(Number); ++plane) {
    for (std::size_t i = plane; i < whole.size(); i += sizeof(Number)) {
      bytes.push_back(whole[i]);
    }
  }
}

/// Appends a list and says how it is coded.
template <class Number>
const char* append(const std::vector<std::byte>& list,
                   std::vector<std::byte>& bytes) {
  std::vector<Number> numbers(list.size() / sizeof(Number));
  std::memcpy(numbers.data(), list.data(), numbers.size() * sizeof(Number));
  if constexpr (std::is_floating_point_v<Number>) {
    append_planes(numbers, bytes);
    return "plain";
  } else {
    if constexpr (std::is_unsigned_v<Number>) {
      const auto codes = firsts(numbers);
      if (codes.size() == numbers.size()) {
        append_planes(codes, bytes);
        return "firsts";
      }
    }
    append_planes(steps(numbers), bytes);
    return "steps";
  }
}

void pack_lists(ordered_json& json, std::vector<std::byte>& bytes) {
  if (!json.is_object() || !json.contains("base64")) {
    for (auto& value : json) {
      if (value.is_structured()) pack_lists(value, bytes);
    }
    return;
  }
  const JsonNode list(json, "view of a part:");
  const auto content =
      bytes_of_base64(list.at("base64").text(), "view of a part");
  ordered_json place = {{"type", list.at("type").text()}, {"at", bytes.size()}};
  with_stored_type(list, [&](auto number) {
    place["count"] = content.size() / sizeof number;
    place["code"] = append<decltype(number)>(content, bytes);
  });
  json = std::move(place);
}

}  // namespace

std::vector<std::byte> packed_part(std::string_view view) {
  ordered_json json = ordered_json::parse(view);
  std::vector<std::byte> lists;
  pack_lists(json, lists);
  const std::string header = json.dump();
  const std::vector<std::uint32_t> length{
      static_cast<std::uint32_t>(header.size())};
  std::vector<std::byte> bytes;
  for (const auto part :
       {std::as_bytes(std::span(length)), std::as_bytes(std::span(header)),
        std::as_bytes(std::span(lists))}) {
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  return bytes;
}

}  // namespace clevis::report
