#include "assessment/stability/buckling_check.h"

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

/// A clamped column under a pressure on its free end.
PartJob column(double pressure) {
  PartJob job;
  job.part.name = "column";
  job.part.material = {"steel", kModulus, 0.0, 7850.0, 355e6};
  job.model = ModelKind::kSolid;
  job.mesh = support::structured_mesh<3>(
      {8, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return x.cwiseProduct(Vector3d(kLength, kWidth, kWidth));
      });
  job.mass = mesh::mass_properties(job.mesh, 7850.0);
  LoadSet set;
  set.fixed = {{"x0", {true, true, true}}};
  set.history = pressed(pressure);
  job.load_sets = {set};
  return job;
}

double euler(double pressure) {
  const double second_moment = kWidth * kWidth * kWidth * kWidth / 12.0;
  return std::numbers::pi * std::numbers::pi * kModulus * second_moment /
         (4.0 * kLength * kLength) / (pressure * kWidth * kWidth);
}

TEST(BucklingCheck, ClampedColumnIsEulers) {
  const auto result = check_buckling(column(100e6)).result;
  EXPECT_NEAR(result.factor.value(), euler(100e6), 0.01 * euler(100e6));
}

// The other sharing presses it twice as much: the band holds that.
TEST(BucklingCheck, OtherSharingsLowerTheBand) {
  PartJob job = column(100e6);
  OpenSharing sharing;
  sharing.checked = pressed(100e6);
  sharing.others = {pressed(200e6), pressed(50e6)};
  job.open_sharings = {sharing};
  const auto result = check_buckling(job).result;
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
// eight times as long it does not.
TEST(BucklingCheck, CompactTetrahedraNeedOneDegreeWhereNothingBuckles) {
  constexpr double kPressure = 0.5e6;
  ASSERT_GT(euler(kPressure), 200.0);
  const auto compact =
      check_buckling(column_of_tetrahedra({20, 1, 1}, kPressure)).result;
  EXPECT_EQ(compact.model, "3-D, p = 2");
  EXPECT_LT(compact.band_low, 100.0 / 2.9);
  EXPECT_GT(compact.band_low, 30.0);
  const auto slender =
      check_buckling(column_of_tetrahedra({3, 1, 1}, kPressure)).result;
  EXPECT_EQ(slender.model, "3-D, p = 3");
}

// What is found is still told by two degrees.
TEST(BucklingCheck, TetrahedraHaveEulersLoadInTheirBand) {
  const auto result =
      check_buckling(column_of_tetrahedra({20, 1, 1}, 20e6)).result;
  EXPECT_NE(result.model, "3-D, p = 2");
  EXPECT_NEAR(result.factor.value(), euler(20e6), 0.02 * euler(20e6));
}

}  // namespace
}  // namespace clevis::assessment
