#include "assessment/buckling/buckling_check.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/quality/mass_properties.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.2, kWidth = 0.01, kModulus = 200e9;

loads::LoadHistory pressed(double pressure) {
  loads::SurfaceLoad load;
  load.group = "x1";
  load.traction = {-pressure, 0.0, 0.0};
  load.resultant.force = kWidth * kWidth * load.traction;
  load.resultant.moment =
      Vector3d(kLength, kWidth / 2, kWidth / 2).cross(load.resultant.force);
  loads::InstantLoad instant;
  instant.label = "press";
  instant.surface_loads = {load};
  loads::LoadHistory history;
  history.instants = {instant};
  return history;
}

/// A clamped column of `size` under a pressure on its free end.
PartJob column_of(std::array<int, 3> cells, double pressure,
                  const Vector3d& size) {
  PartJob job;
  job.part.name = "column";
  job.part.material = {"steel", kModulus, 0.0, 7850.0, 355e6};
  job.model = ModelKind::kSolid;
  job.mesh =
      support::structured_mesh<3>(cells, 1, [&](const Vector3d& x) -> Vector3d {
        return x.cwiseProduct(size);
      });
  job.mass = mesh::mass_properties(job.mesh, 7850.0);
  LoadSet set;
  set.fixed = {{"x0", {true, true, true}}};
  set.history = pressed(pressure);
  job.load_sets = {set};
  return job;
}

PartJob column_of_hexahedra(std::array<int, 3> cells, double pressure) {
  return column_of(cells, pressure, {kLength, kWidth, kWidth});
}

PartJob column(double pressure) {
  return column_of_hexahedra({8, 1, 1}, pressure);
}

BucklingCheck buckling_of(const PartJob& job) {
  BucklingModel model(job);
  return check_buckling(job, {}, model);
}

double euler(double pressure) {
  const double second_moment = kWidth * kWidth * kWidth * kWidth / 12.0;
  return std::numbers::pi * std::numbers::pi * kModulus * second_moment /
         (4.0 * kLength * kLength) / (pressure * kWidth * kWidth);
}

TEST(BucklingCheck, ClampedColumnIsEulers) {
  const auto result = buckling_of(column(100e6)).result;
  EXPECT_NEAR(result.factor.value(), euler(100e6), 0.01 * euler(100e6));
}

// Supports in its plane alone hold a plate well enough to buckle within it.
TEST(BucklingCheck, PlateHeldInItsPlaneAlone) {
  PartJob job = column(100e6);
  job.model.reset();
  const double across = buckling_of(job).result.factor.value();
  job.load_sets[0].fixed = {{"x0", {true, true, false}}};
  const auto result = buckling_of(job).result;
  EXPECT_NEAR(result.factor.value(), across, 1e-6 * across);
  EXPECT_NE(result.remark.find("across its plane"), std::string::npos);
}

TEST(BucklingCheck, IsOfTheMeshBeforeItsRefinement) {
  PartJob refined = column_of_hexahedra({16, 2, 2}, 100e6);
  refined.unrefined = column(100e6).mesh;
  const auto factor = [](const PartJob& job) {
    return buckling_of(job).result.factor.value();
  };
  EXPECT_EQ(factor(refined), factor(column(100e6)));
  refined.unrefined.reset();
  EXPECT_NE(factor(refined), factor(column(100e6)));
}

// The other sharing presses it twice as much: the band holds that.
TEST(BucklingCheck, OtherSharingsLowerTheBand) {
  PartJob job = column(100e6);
  OpenSharing sharing;
  sharing.checked = pressed(100e6);
  sharing.others = {pressed(200e6), pressed(50e6)};
  job.open_sharings = {sharing};
  const auto result = buckling_of(job).result;
  EXPECT_NEAR(result.factor.value(), euler(100e6), 0.01 * euler(100e6));
  EXPECT_NEAR(result.band_low, euler(200e6), 0.02 * euler(200e6));
}

PartJob column_of_tetrahedra(std::array<int, 3> cells, double pressure) {
  PartJob job = column(pressure);
  job.mesh =
      support::simplex_mesh<3>(cells, 1, [](const Vector3d& x) -> Vector3d {
        return x.cwiseProduct(Vector3d(kLength, kWidth, kWidth));
      });
  return job;
}

// Far from buckling, degree 2 on cells as long as wide tells enough, on cells
// seven times as long it does not.
template <typename Column>
void expect_one_degree_where_compact(Column column_of) {
  constexpr double kPressure = 0.2e6;
  ASSERT_GT(euler(kPressure), 500.0);
  const auto compact = buckling_of(column_of({20, 1, 1}, kPressure)).result;
  EXPECT_EQ(compact.model, "3-D, p = 2");
  EXPECT_NEAR(compact.band_low, 100.0, 1e-9);
  const auto slender = buckling_of(column_of({3, 1, 1}, kPressure)).result;
  EXPECT_EQ(slender.model, "3-D, p = 3");
}

TEST(BucklingCheck, CompactCellsNeedOneDegreeWhereNothingBuckles) {
  expect_one_degree_where_compact(column_of_tetrahedra);
  expect_one_degree_where_compact(column_of_hexahedra);
}

// On cells nearly as long as a compact one may be, of a bar, and longer, of a
// strip that bends out of its plane, degree 2 is not thrice too high.
TEST(BucklingCheck, DegreeTwoOfCompactCellsIsNotThriceTooHigh) {
  constexpr double kPressure = 20e6;
  PartJob bar = column_of_hexahedra({7, 1, 1}, kPressure);
  bar.max_dofs = 600;
  const auto of_bar = buckling_of(bar).result;
  EXPECT_EQ(of_bar.model, "3-D, p = 2");
  EXPECT_LE(of_bar.factor.value(), 1.5 * euler(kPressure));
  EXPECT_GE(of_bar.factor.value(), euler(kPressure));

  PartJob strip = column(kPressure);
  strip.model = std::nullopt;
  const double thickness = 0.21 * kWidth;
  strip.mesh = support::structured_mesh<3>(
      {34, 1, 1}, 1, [&](const Vector3d& x) -> Vector3d {
        return Vector3d(kLength * x.x(), kWidth * x.y(),
                        thickness * (x.z() - 0.5));
      });
  auto& load = strip.load_sets[0].history.instants[0].surface_loads[0];
  load.resultant.force *= thickness / kWidth;
  load.resultant.moment =
      Vector3d(kLength, kWidth / 2, 0.0).cross(load.resultant.force);
  strip.max_dofs = 3000;
  const auto of_strip = buckling_of(strip).result;
  EXPECT_EQ(of_strip.model, "2-D x thickness, p = 2");
  const double thin = std::pow(thickness / kWidth, 2) * euler(kPressure);
  EXPECT_LE(of_strip.factor.value(), 1.5 * thin);
  EXPECT_GE(of_strip.factor.value(), 0.999 * thin);
}

// What is wanted beyond 100 is looked for.
// Far from the limit the wide band of the first degree decides.
TEST(BucklingCheck, CompactCellsNeedOneDegreeForAWideTolerance) {
  const auto result_of = [](double pressure, double tolerance,
                            bool is_case = true) {
    PartJob job = column_of_hexahedra({20, 1, 1}, pressure);
    job.load_sets[0].history.instants[0].is_case = is_case;
    job.tolerance = tolerance;
    return buckling_of(job).result;
  };
  const auto wide = result_of(10e6, 0.03);
  EXPECT_TRUE(wide.model.ends_with("p = 2")) << wide.model;
  EXPECT_LE(wide.band_low, euler(10e6));
  // Shear lowers Euler's load by 1.2 P/GA (Engesser), 0.12 %.
  EXPECT_NEAR(wide.band_high, euler(10e6), 0.003 * euler(10e6));
  EXPECT_TRUE(result_of(10e6, 0.029).model.ends_with("p = 3"));
  // Parts of a mechanism yield together.
  EXPECT_TRUE(result_of(10e6, 0.03, false).model.ends_with("p = 3"));
  // A third of 4 may be below the limit.
  EXPECT_TRUE(result_of(25e6, 0.03).model.ends_with("p = 3"));
}

TEST(BucklingCheck, LimitAbove100IsJudged) {
  PartJob job = column_of_hexahedra({20, 1, 1}, 0.1e6);
  job.part.limits.buckling = 150.0;
  ASSERT_GT(euler(0.1e6), 1000.0);
  EXPECT_NEAR(buckling_of(job).result.band_low, 450.0, 1e-9);
  job = column_of_hexahedra({20, 1, 1}, 0.8e6);
  job.part.limits.buckling = 150.0;
  EXPECT_NEAR(buckling_of(job).result.factor.value(), euler(0.8e6), 1.5);
}

// One degree of one cell does not tell how a plate buckles in shear or about
// its wide side: cells longer than three times their height have two.
TEST(BucklingCheck, FlatHexahedraNeedTwoDegrees) {
  const auto model = [](double height) {
    const PartJob job =
        column_of({5, 1, 1}, 0.02e6, Vector3d(kLength / 4.0, kWidth, height));
    return buckling_of(job).result.model;
  };
  EXPECT_EQ(model(kWidth), "3-D, p = 2");
  EXPECT_EQ(model(kWidth / 4.0), "3-D, p = 3");
}

// A factor that the first degree has above 100, but not three times: the second
// one tells.
TEST(BucklingCheck, CompactCellsNeedTwoDegreesNearTheHighest) {
  constexpr double kPressure = 0.5e6;
  ASSERT_GT(euler(kPressure), 200.0);
  ASSERT_LT(euler(kPressure), 290.0);
  for (const PartJob& job : {column_of_tetrahedra({20, 1, 1}, kPressure),
                             column_of_hexahedra({20, 1, 1}, kPressure)}) {
    const auto result = buckling_of(job).result;
    EXPECT_EQ(result.model, "3-D, p = 3");
    EXPECT_NEAR(result.band_low, 100.0, 1e-9);
  }
}

// What is found is still told by two degrees.
TEST(BucklingCheck, TetrahedraHaveEulersLoadInTheirBand) {
  const auto result =
      buckling_of(column_of_tetrahedra({20, 1, 1}, 20e6)).result;
  EXPECT_NE(result.model, "3-D, p = 2");
  EXPECT_NEAR(result.factor.value(), euler(20e6), 0.02 * euler(20e6));
}

TEST(Standing, OfSeveralLoadSetsIsThatOfTheLeastFactor) {
  Standing all;
  all.take({{std::nullopt, true}, "stands", 1.0});
  EXPECT_FALSE(all.position.topples);
  EXPECT_TRUE(all.position.is_open);
  all.take({{0.9, false}, "leans", 2.0});
  all.take({{0.5, false}, "falls", 3.0});
  all.take({{0.7, false}, "leans more", 4.0});
  EXPECT_EQ(all.position.topples, 0.5);
  EXPECT_EQ(all.label, "falls");
  EXPECT_EQ(all.instant, 3.0);
  EXPECT_TRUE(all.position.is_open);
}

TEST(Standing, SpringsAndThePartYieldInSeries) {
  BucklingResult result;
  result.factor = result.band_high = 4.0;
  result.band_low = 3.0;
  count_standing({}, 3.0, result);
  EXPECT_EQ(result.factor, 4.0);
  EXPECT_TRUE(result.remark.empty());
  count_standing({{0.6, false}, "end", 2.0}, 3.0, result);
  EXPECT_EQ(result.factor, 0.6);
  EXPECT_EQ(result.band_high, 0.6);
  EXPECT_DOUBLE_EQ(result.band_low, 0.5);  // 1/(1/0.6 + 1/3)
  EXPECT_EQ(result.label, "end");
  EXPECT_NE(result.remark.find("springs and servo axes alone"),
            std::string::npos);
  // Nothing holds it.
  count_standing({{0.0, false}, "end", 2.0}, 3.0, result);
  EXPECT_EQ(result.factor, 0.0);
  EXPECT_EQ(result.band_low, 0.0);
  EXPECT_FALSE(result.is_lower_bound());
  EXPECT_NE(result.remark.find("nothing holds it"), std::string::npos);
}

// Springs that hold at once are in the band, and not in what yields slowly.
TEST(Standing, WhatYieldsSlowlyCountsWhereItIsLess) {
  const auto slowly = [](double factor) {
    return Standing{{.topples = factor, .yields_slowly = true}, "end", 2.0};
  };
  BucklingResult result;
  count_standing(slowly(0.5), 3.0, result);
  EXPECT_FALSE(result.factor);  // not computed
  result.factor = result.band_high = 4.0;
  result.band_low = 1.5;
  count_standing(slowly(5.0), 3.0, result);
  EXPECT_EQ(result.factor, 4.0);
  EXPECT_EQ(result.band_low, 1.5);
  count_standing(slowly(2.0), 3.0, result);
  EXPECT_EQ(result.factor, 2.0);
  EXPECT_DOUBLE_EQ(result.band_low, 1.2);  // 1/(1/2 + 1/3)
  EXPECT_NE(result.remark.find("friction"), std::string::npos);
  EXPECT_EQ(result.remark.find("not stable"), std::string::npos);
  count_standing(slowly(0.5), 3.0, result);
  EXPECT_NE(result.remark.find("not stable"), std::string::npos);
  Standing all;
  all.take({{.topples = 0.9}, "springs", 1.0});
  all.take(slowly(0.5));
  EXPECT_TRUE(all.position.yields_slowly);
  all.take({{.topples = 0.4}, "springs", 1.0});
  EXPECT_FALSE(all.position.yields_slowly);
}

}  // namespace
}  // namespace clevis::assessment
