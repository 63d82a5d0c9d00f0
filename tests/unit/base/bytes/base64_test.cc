#include "base/bytes/base64.h"

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis {
namespace {

std::string encoded(std::string_view text) {
  return base64(std::as_bytes(std::span(text)));
}

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Base64, ReadsBackEveryByte) {
  std::vector<std::byte> bytes;
  for (int b = 0; b < 256; ++b) bytes.push_back(static_cast<std::byte>(b));
  for (std::size_t n = 253; n <= 256; ++n) {
    bytes.resize(n);
    EXPECT_EQ(bytes_of_base64(base64(bytes), "here"), bytes);
  }
}

TEST(Base64, RefusesOtherTextAtItsPlace) {
  try {
    bytes_of_base64("Zm9v<", "view of AB");
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "I003");
    EXPECT_EQ(error.place(), "view of AB");
  }
}

}  // namespace
}  // namespace clevis
