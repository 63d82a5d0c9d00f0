#include "report/text/json_text.h"

#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

TEST(JsonText, DoublesReadBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3.0, 55.013, 6.65709e-3, 1e-310, -0.0,
                             std::numeric_limits<double>::max()}) {
    const double back = ordered_json::parse(json_text(value)).get<double>();
    EXPECT_EQ(back, value);
    EXPECT_EQ(std::signbit(back), std::signbit(value));
  }
  EXPECT_EQ(json_text(0.1), "0.1\n") << "not the shortest text";
}

TEST(JsonText, NonFiniteNumberIsRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ordered_json document = {{"peak", {{"band_MPa", {1.0, nan}}}}};
  try {
    refuse_non_finite(document, "part DCE");
    FAIL() << "NaN was let through";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F003");
    EXPECT_EQ(error.place(), "part DCE");
    EXPECT_EQ(error.problem(), "peak/band_MPa/1 is nan, not a finite number");
  }
  EXPECT_NO_THROW(refuse_non_finite({{"a", nullptr}, {"b", 1.0}}, "x"));
}

TEST(JsonText, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_EQ(valid_utf8("bore_\xff!"), "bore_\xef\xbf\xbd!");
  EXPECT_EQ(valid_utf8("Öse \"A\""), "Öse \"A\"");
}

std::string place_of_refusal(const std::filesystem::path& file) {
  try {
    read_json(file);
  } catch (const Error& error) {
    return error.code() + error.place().substr(file.string().size());
  }
  return {};
}

TEST(JsonText, DamageIsReportedWithLineAndColumn) {
  const TestFolder folder;
  const auto file = folder / "result.json";
  std::ofstream(file) << "{\"a\": 1,\n \"b\": oops}\n";
  EXPECT_EQ(place_of_refusal(file), "I003:2:7");
  std::ofstream(file) << "{\"a\": [1, 2";  // cut off
  EXPECT_EQ(place_of_refusal(file), "I003:1:12");
  std::ofstream(file) << "";
  EXPECT_EQ(place_of_refusal(file), "I003:1:1");
  std::ofstream(file) << "[1e999]";
  EXPECT_EQ(place_of_refusal(file), "I003");
}

TEST(JsonText, AbsentFileAndFolderAreRefused) {
  const TestFolder folder;
  EXPECT_EQ(place_of_refusal(folder / "none.json"), "I001");
  EXPECT_EQ(place_of_refusal(folder.path()), "I001");
}

}  // namespace
}  // namespace clevis::report
