#include "report/quantities/quantity.h"

#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/quantities/quantity_csv.h"
#include "report/quantities/quantity_json.h"

namespace clevis::report {
namespace {

struct Inner {
  double low{}, high{};  ///< [m]
};

struct Sample {
  std::string name;
  std::optional<double> stress{};  ///< [Pa]
  Inner inner{};
  Eigen::Vector3d at = {0.001, 0.002, -0.003};  ///< [m]
  bool has_inner = true;
};

Quantities<Sample> sample_rows() {
  Quantities<Sample> rows{
      quantity<Sample>({"name", "/name", "", "name"}, &Sample::name),
      quantity<Sample>({"stress", "/peak/stress_MPa", "MPa", "stress"},
                       &Sample::stress),
      quantity<Sample>({"at", "/at_mm", "mm", "at"}, &Sample::at)};
  const Quantities<Inner> inner{
      quantity<Inner>({"low", "/band_mm/0", "mm", "low"}, &Inner::low),
      quantity<Inner>({"high", "/band_mm/1", "mm"}, &Inner::high)};
  add_rows_of(
      inner, "/inner", true,
      [](const Sample& sample) {
        return sample.has_inner ? &sample.inner : nullptr;
      },
      rows);
  return rows;
}

TEST(Quantity, JsonHasKeysUnitsAndBands) {
  const auto json = quantities_json(
      {.name = "A", .stress = 2.5e6, .inner = {1.0, 2.0}}, sample_rows());
  EXPECT_EQ(json.dump(),
            R"({"name":"A","peak":{"stress_MPa":2.5},"at_mm":[1.0,2.0,-3.0],)"
            R"("inner":{"band_mm":[1000.0,2000.0]}})");
}

TEST(Quantity, WhatIsNotKnownIsNullAsAWhole) {
  const Sample sample{.name = "A", .has_inner = false};
  const auto json = quantities_json(sample, sample_rows());
  EXPECT_TRUE(json.at("peak").is_null());
  EXPECT_TRUE(json.at("inner").is_null());
  const auto left = quantities_json(sample, sample_rows(), Unknown::kLeftOut);
  EXPECT_EQ(left.size(), 2u);
}

TEST(Quantity, OptionalMayLackAndSoMayAllOfWhatMayBeAbsent) {
  const auto rows = sample_rows();
  EXPECT_FALSE(rows[0].may_lack);
  EXPECT_TRUE(rows[1].may_lack);
  EXPECT_TRUE(rows[3].may_lack);
  EXPECT_EQ(rows[0].kind, QuantityKind::kText);
  EXPECT_EQ(rows[2].kind, QuantityKind::kPoint);
}

TEST(Quantity, CsvHasAColumnPerRowThatWantsOne) {
  const Sample sample{.name = "A, B", .inner = {1.0, 2.0}};
  std::vector<CsvCell> cells;
  add_csv_cells(&sample, sample_rows(), cells);
  EXPECT_EQ(csv_line(cells, &CsvCell::title),
            "name,stress[MPa],at_x[mm],at_y[mm],at_z[mm],low[mm]\r\n");
  EXPECT_EQ(csv_line(cells, &CsvCell::text), "\"A, B\",,1,2,-3,1000\r\n");
}

TEST(Quantity, UnitsOfFilesAreMultiplesOfSi) {
  EXPECT_EQ(in_unit(355e6, "MPa"), 355.0);
  EXPECT_EQ(in_unit(0.14, "mm"), 140.0);
  EXPECT_EQ(in_unit(0.5, "%"), 50.0);
  EXPECT_EQ(in_unit(7200.0, "h"), 2.0);
  EXPECT_DOUBLE_EQ(in_unit(std::numbers::pi, "deg"), 180.0);
  EXPECT_EQ(in_unit(2.0, "1"), 2.0);
}

}  // namespace
}  // namespace clevis::report
