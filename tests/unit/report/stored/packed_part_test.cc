#include "report/stored/packed_part.h"

#include <cmath>
#include <cstring>
#include <span>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/bytes/base64.h"
#include "base/bytes/compression.h"
#include "base/messages/errors.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

template <class Number>
ordered_json list_of(const char* type, const std::vector<Number>& numbers) {
  return {{"type", type}, {"base64", base64_of(numbers)}};
}

/// A packed part as the page reads it.
class Unpacked {
 public:
  explicit Unpacked(const ordered_json& view)
      : bytes_(packed_part(view.dump())) {
    std::uint32_t length{};
    std::memcpy(&length, bytes_.data(), sizeof length);
    lists_ = 4 + length;
    const auto* text = reinterpret_cast<const char*>(bytes_.data()) + 4;
    header_ = ordered_json::parse(text, text + length);
  }

  const ordered_json& header() const { return header_; }
  std::size_t size() const { return bytes_.size(); }

  /// The list of a key: bytes by planes, numbers by their code.
  template <class Number>
  std::vector<Number> list(const char* key) const {
    const ordered_json& place = header_[key];
    const auto count = place["count"].get<std::size_t>();
    const auto at = lists_ + place["at"].get<std::size_t>();
    std::vector<Number> numbers(count);
    auto* whole = reinterpret_cast<std::byte*>(numbers.data());
    for (std::size_t plane = 0; plane < sizeof(Number); ++plane) {
      for (std::size_t i = 0; i < count; ++i) {
        whole[sizeof(Number) * i + plane] = bytes_[at + plane * count + i];
      }
    }
    return decoded(numbers, place["code"].get<std::string>());
  }

 private:
  template <class Number>
  static std::vector<Number> decoded(std::vector<Number> numbers,
                                     const std::string& code) {
    std::int64_t before = 0, next = 0;
    for (Number& number : numbers) {
      if (code == "firsts") {
        number = static_cast<Number>(next - static_cast<std::int64_t>(number));
        if (static_cast<std::int64_t>(number) == next) ++next;
      } else if (code == "steps") {
        constexpr std::int64_t kMask =
            (std::int64_t{1} << 8 * sizeof(Number)) - 1;
        const std::int64_t folded = static_cast<std::int64_t>(number) & kMask;
        before += folded % 2 == 1 ? -(folded + 1) / 2 : folded / 2;
        number = static_cast<Number>(before);
      }
    }
    return numbers;
  }

  std::vector<std::byte> bytes_;
  std::size_t lists_{};
  ordered_json header_;
};

TEST(PackedPart, HoldsEveryListAsItWas) {
  const std::vector<float> reals{0.5F, -2e30F, 3.25F};
  const std::vector<std::int8_t> bytes{0, -128, 127, 127, -1};
  const std::vector<std::int16_t> words{-32768, 32767, 0, 5};
  const std::vector<std::uint16_t> places{7, 65535, 0, 3};
  const std::vector<std::uint16_t> corners{0, 1, 2, 2, 1, 3, 0, 4};
  const std::vector<std::uint32_t> many{0, 4294967295U, 70000};
  const Unpacked part(ordered_json{{"name", "part"},
                                   {"reals", list_of("f32", reals)},
                                   {"bytes", list_of("i8", bytes)},
                                   {"words", list_of("i16", words)},
                                   {"places", list_of("u16", places)},
                                   {"corners", list_of("u16", corners)},
                                   {"many", list_of("u32", many)}});
  EXPECT_EQ(part.header()["name"], "part");
  EXPECT_EQ(part.list<float>("reals"), reals);
  EXPECT_EQ(part.list<std::int8_t>("bytes"), bytes);
  EXPECT_EQ(part.list<std::int16_t>("words"), words);
  EXPECT_EQ(part.list<std::uint16_t>("places"), places);
  EXPECT_EQ(part.list<std::uint16_t>("corners"), corners);
  EXPECT_EQ(part.list<std::uint32_t>("many"), many);
  EXPECT_EQ(part.header()["reals"]["code"], "plain");
  EXPECT_EQ(part.header()["places"]["code"], "steps");
  EXPECT_EQ(part.header()["corners"]["code"], "firsts");
}

TEST(PackedPart, ListsWithinListsAreFound) {
  const std::vector<std::int16_t> column{3, 4, 6};
  const ordered_json field = {
      {"columns", ordered_json::array({list_of("i16", column)})}};
  const Unpacked part(ordered_json{{"field", field}});
  EXPECT_EQ(part.header()["field"]["columns"][0]["count"], 3);
}

// A smooth field and the corners of a strip: base 64 hides from zlib what
// repeats.
TEST(PackedPart, TakesAThirdOfTheCompressedView) {
  std::vector<std::int16_t> smooth;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    smooth.push_back(static_cast<std::int16_t>(4000 * std::sin(3e-4 * i)));
    corners.insert(corners.end(), {i, i + 1, i + 2});
  }
  const ordered_json view = {{"smooth", list_of("i16", smooth)},
                             {"corners", list_of("u32", corners)}};
  const std::string text = view.dump();
  const auto plain = compressed(std::as_bytes(std::span(text)));
  EXPECT_LT(3 * compressed(packed_part(text)).size(), plain.size());
}

TEST(PackedPart, DamagedListsAreRefused) {
  for (const ordered_json& list :
       {ordered_json{{"type", "f32"}, {"base64", "?"}},
        ordered_json{{"type", "f64"}, {"base64", ""}},
        ordered_json{{"base64", ""}}}) {
    try {
      packed_part(ordered_json{{"numbers", list}}.dump());
      ADD_FAILURE() << list;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "I003");
    }
  }
}

}  // namespace
}  // namespace clevis::report
