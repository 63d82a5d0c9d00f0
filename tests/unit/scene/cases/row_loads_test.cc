#include "scene/cases/row_loads.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis::scene {
namespace {

using Eigen::Vector3d;
using part::BetweenRows;
using part::SeriesInstant;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kRoundOff = 1e-12;

/// Turned about z; pushed along the file's x.
RowLoads row(double time, double angle, double force, double spin = 0.0) {
  RowLoads row;
  row.loads.time = time;
  row.loads.forces = {Vector3d(force, 0.0, 0.0)};
  row.loads.moments = {Vector3d::Zero()};
  row.loads.pressures = {force};
  row.loads.angular_velocity = {0.0, 0.0, spin};
  row.orientation = Eigen::AngleAxisd(angle, Vector3d::UnitZ());
  row.place = "loads.csv:" + std::to_string(static_cast<int>(time)) + ":1";
  return row;
}

std::string refusal(const std::vector<RowLoads>& rows) {
  try {
    require_known_turns(rows);
  } catch (const Error& error) {
    return error.code() + " " + error.place();
  }
  return "";
}

TEST(RowLoads, AForceThatStandsInSpaceTurnsInThePart) {
  const double whole = 80.0 * kDegree;
  for (const auto between : {BetweenRows::kUnknown, BetweenRows::kLinear}) {
    const std::vector<SeriesInstant> instants =
        instants_in_part({row(0.0, 0.0, 5.0), row(2.0, whole, 5.0)}, between);
    ASSERT_GE(instants.size(), 13u);
    EXPECT_FALSE(instants.front().is_between_rows);
    EXPECT_FALSE(instants.back().is_between_rows);
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const double angle = 0.5 * instants[i].time * whole;
      const Vector3d wanted =
          5.0 * Vector3d(std::cos(angle), -std::sin(angle), 0.0);
      EXPECT_NEAR((instants[i].forces[0] - wanted).norm(), 0.0, kRoundOff);
      EXPECT_EQ(instants[i].is_between_rows, i > 0 && i + 1 < instants.size());
      if (i == 0) continue;
      // The chord beside the arc: a 10 000th.
      const Vector3d step = wanted - instants[i - 1].forces[0];
      EXPECT_LT(step.squaredNorm() / 8.0, 1.3e-4 * 25.0);
    }
  }
}

TEST(RowLoads, WhatFadesAsItTurnsIsFollowed) {
  // 5 (1 - t) along space, the part turned by a t: across it, a parabola that
  // is zero at both rows.
  const double a = 1.0 * kDegree;
  const std::vector<SeriesInstant> instants = instants_in_part(
      {row(0.0, 0.0, 5.0), row(1.0, a, 0.0)}, BetweenRows::kLinear);
  double across = 0.0;
  for (const SeriesInstant& instant : instants) {
    across = std::max(across, -instant.forces[0].y());
    EXPECT_NEAR(instant.pressures[0], 5.0 * (1.0 - instant.time), kRoundOff);
  }
  EXPECT_NEAR(across, 5.0 * 0.25 * a, 1e-4);
}

TEST(RowLoads, StraightLinesHaveNoInstants) {
  const double little = 0.01;
  EXPECT_EQ(instants_in_part({row(0.0, 0.0, 5.0), row(1.0, 0.0, -5.0),
                              row(1.0, 1.0, 5.0), row(2.0, 1.0 + little, 5.0)},
                             BetweenRows::kLinear)
                .size(),
            4u);
}

TEST(RowLoads, TheSquareOfAChangingSpinIsNoLine) {
  const std::vector<RowLoads> rows{row(0.0, 0.0, 0.0, 0.0),
                                   row(1.0, 0.0, -8.0, 100.0)};
  EXPECT_EQ(instants_in_part(rows, BetweenRows::kUnknown).size(), 2u);
  const auto instants = instants_in_part(rows, BetweenRows::kLinear);
  ASSERT_EQ(instants.size(), 13u);
  EXPECT_NEAR(instants[6].angular_velocity.z(), 50.0, kRoundOff);
  EXPECT_NEAR(instants[6].forces[0].x(), -4.0, kRoundOff);
}

TEST(RowLoads, TurnsThatMayGoEitherWayAreRefused) {
  const auto turned = [](double degrees) {
    return refusal({row(0.0, 0.3, 1.0), row(1.0, 0.3, 1.0),
                    row(2.0, 0.3 + degrees * kDegree, 1.0)});
  };
  EXPECT_EQ(turned(89.0), "");
  EXPECT_EQ(turned(-89.0), "");
  EXPECT_EQ(turned(90.0), "S006 loads.csv:2:1");
  EXPECT_EQ(turned(180.0), "S006 loads.csv:2:1");
  EXPECT_EQ(turned(-135.0), "S006 loads.csv:2:1");
  // Once around: its angular velocity alone tells.
  EXPECT_EQ(turned(360.0), "");
  const double once = 2.0 * std::numbers::pi;
  EXPECT_EQ(refusal({row(0.0, 0.0, 1.0, once), row(1.0, 0.0, 1.0, once)}),
            "S006 loads.csv:1:1");
  EXPECT_EQ(refusal({row(1.0, 0.0, 1.0), row(1.0, 2.0, 1.0)}), "");  // a step
}

}  // namespace
}  // namespace clevis::scene
