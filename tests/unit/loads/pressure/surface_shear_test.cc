// Shear by group, by hand.
#include "loads/pressure/surface_shear.h"

#include <numbers>

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kRadius = 0.01, kLength = 0.02;

std::vector<GroupGeometry> groups() {
  GroupGeometry bore;
  bore.name = "bore";
  bore.is_cylinder = true;
  bore.cylinder = {.p_LC = Vector3d::Zero(),
                   .axis_L = Vector3d::UnitZ(),
                   .radius = kRadius,
                   .length = kLength};
  bore.area = 2.0 * pi * kRadius * kLength;
  GroupGeometry face;
  face.name = "face";
  face.area = 1e-4;
  face.area_vector = 1e-4 * Vector3d::UnitX();
  return {bore, face};
}

Seat seat(const std::string& group, SeatKind kind) {
  return {.name = group, .group = group, .kind = kind};
}

// A pin's force along its axis and the moment about it; what presses does not
// count.
TEST(SurfaceShear, OfAPin) {
  LoadHistory history;
  history.seats = {seat("bore", SeatKind::kBearing)};
  history.instants.resize(2);
  history.instants[0].wrenches = {{{500.0, 0.0, 300.0}, {0.0, 0.0, 4.0}}};
  history.instants[1].wrenches = {{{900.0, 0.0, 100.0}, Vector3d::Zero()}};
  const double wall = 2.0 * pi * kRadius * kLength;
  const GroupShear found = surface_shear(history, groups()).at("bore");
  EXPECT_LT((found.even.col(0) - Vector3d(0.0, 0.0, 300.0 / wall)).norm(),
            1e-9 / wall);
  EXPECT_NEAR(found.turning[0], 4.0 / kRadius / wall, 1e-9 / wall);
  EXPECT_NEAR(found.even(2, 1), 100.0 / wall, 1e-9 / wall);
  EXPECT_EQ(found.turning[1], 0.0);
}

// Of a flat face the force along it, a moment about its normal as on a circle
// of its area.
TEST(SurfaceShear, OfAFace) {
  LoadHistory history;
  history.seats = {seat("face", SeatKind::kTraction)};
  history.instants.resize(1);
  history.instants[0].wrenches = {{{500.0, 30.0, 40.0}, Vector3d::Zero()}};
  EXPECT_LT((surface_shear(history, groups()).at("face").even.col(0) -
             Vector3d(0.0, 30.0, 40.0) / 1e-4)
                .norm(),
            1e-3);
  history.instants[0].wrenches = {{{500.0, 0.0, 0.0}, {1.0, 7.0, 7.0}}};
  const double radius = std::sqrt(1e-4 / pi);
  EXPECT_NEAR(surface_shear(history, groups()).at("face").turning[0],
              1.0 / (0.5 * pi * std::pow(radius, 3)), 1e-3);
}

TEST(SurfaceShear, OfATractionButNotOfWhatPresses) {
  LoadHistory history;
  history.instants.resize(1);
  history.instants[0].surface_loads = {
      {.group = "face", .traction = {3e6, 4e6, 0.0}, .total = 5e2}};
  EXPECT_NEAR(surface_shear(history, groups()).at("face").even(1, 0), 4e6,
              1e-3);
  history.instants[0].surface_loads = {
      {.group = "face", .pressure = 3e6, .total = 3e2}};
  EXPECT_TRUE(surface_shear(history, groups()).empty());
  // Round-off of what presses.
  history.instants[0].surface_loads = {
      {.group = "face", .traction = {3e6, 1.0, 0.0}, .total = 3e2}};
  EXPECT_TRUE(surface_shear(history, groups()).empty());
}

TEST(SurfaceShear, SlidesHaveNone) {
  LoadHistory history;
  history.seats = {seat("face", SeatKind::kTraction)};
  history.seats[0].slide.emplace();
  history.instants.resize(1);
  history.instants[0].wrenches = {{{500.0, 30.0, 40.0}, Vector3d::Zero()}};
  EXPECT_TRUE(surface_shear(history, groups()).empty());
}

}  // namespace
}  // namespace clevis::loads
