// Pins that hold a part: reactions by hand, from the balance of forces and
// moments.
#include "loads/parts/held_pins.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "loads/holds/holding_groups.h"
#include "loads/parts/case_loads.h"
#include "loads/parts/part_loads.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

constexpr double kSize = 0.2;

part::Bore bore(const Vector3d& at, const Vector3d& axis) {
  return {.p_LC = at, .axis_L = axis, .radius = 5e-3, .length = 10e-3};
}

GroupGeometry group(const std::string& name, const part::Bore& c) {
  return {.name = name,
          .is_cylinder = true,
          .cylinder = c,
          .centroid = c.p_LC,
          .area = 2.0 * std::numbers::pi * c.radius * c.length};
}

/// A at the origin, B 140 mm along x, C 40 mm along x, axes along z; D on A's
/// axis.
std::vector<GroupGeometry> groups() {
  const Vector3d z = Vector3d::UnitZ();
  return {group("bore_A", bore(Vector3d::Zero(), z)),
          group("bore_B", bore({0.14, 0.0, 0.0}, z)),
          group("bore_C", bore({0.04, 0.0, 0.0}, z)),
          group("bore_D", bore({0.0, 0.0, 0.05}, z))};
}

LoadHistory held(const std::vector<std::string>& by,
                 const std::map<std::string, Vector3d>& pins) {
  part::PartDefinition part;
  part.name = "P";
  part.place = "scene.toml:3:1";
  part::LoadCaseDefinition c;
  c.name = "held";
  c.pins = pins;
  c.held_by_pin = by;
  const part::MassProperties mass{
      .mass = 0.2,
      .p_LCm = {0.07, 0.0, 0.0},
      .inertia_LCm = Vector3d(1e-5, 3e-4, 3e-4).asDiagonal()};
  return case_loads(part, c, groups(), mass);
}

Wrench wrench_of(const LoadHistory& history, const std::string& name) {
  for (std::size_t i = 0; i < history.seats.size(); ++i) {
    if (history.seats[i].group == name) {
      EXPECT_EQ(history.seats[i].kind, SeatKind::kBearing);
      return history.instants[0].wrenches[i];
    }
  }
  ADD_FAILURE() << name;
  return {};
}

TEST(HeldPins, OnePinTakesTheForceAndWhatTiltsIt) {
  const LoadHistory history =
      held({"bore_A"}, {{"bore_B", Vector3d(1000.0, 0.0, 20.0)}});
  const Wrench at_A = wrench_of(history, "bore_A");
  EXPECT_LT((at_A.force - Vector3d(-1000.0, 0.0, -20.0)).norm(), 1e-9);
  // 20 N along z at x = 0.14 m: a moment of −2.8 N m about y
  EXPECT_LT((at_A.moment - Vector3d(0.0, 2.8, 0.0)).norm(), 1e-9);
}

TEST(HeldPins, OnePinTakesNoMomentAboutItsAxis) {
  for (const auto& by : std::vector<std::vector<std::string>>{
           {"bore_A"}, {"bore_A", "bore_D"}}) {
    try {
      held(by, {{"bore_B", Vector3d(1000.0, 500.0, 0.0)}});
      FAIL() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "L001");
      EXPECT_NE(error.problem().find("about the axis (0, 0, 1)"),
                std::string::npos)
          << error.problem();
      EXPECT_NE(error.problem().find("a moment of 70 N m"), std::string::npos)
          << error.problem();
    }
  }
}

// A beam on two supports: the lever rule.
TEST(HeldPins, TwoPinsShareATransverseForceByTheLever) {
  const LoadHistory history =
      held({"bore_A", "bore_B"}, {{"bore_C", Vector3d(0.0, 700.0, 0.0)}});
  EXPECT_NEAR(wrench_of(history, "bore_A").force.y(), -500.0, 1e-9);
  EXPECT_NEAR(wrench_of(history, "bore_B").force.y(), -200.0, 1e-9);
  EXPECT_LT(wrench_of(history, "bore_A").moment.norm(), 1e-9);
}

// Which pins hold decides, not which come first.
TEST(HeldPins, ThoseThatHoldAreTheOnesDeflectionRefersTo) {
  const std::map<std::string, Vector3d> load{
      {"bore_A", Vector3d(0.0, -200.0, 0.0)}};
  EXPECT_EQ(holding_groups(held({"bore_B", "bore_C"}, load)),
            (std::vector<HoldingGroups>{{"bore_B", "bore_C"}}));
  EXPECT_EQ(holding_groups(held({"bore_B"}, {{"bore_A", {100.0, 0.0, 0.0}}})),
            (std::vector<HoldingGroups>{{"bore_B"}}));
}

TEST(HeldPins, WhatIsOpenBalancesItself) {
  const PinReactions pins = pins_in({"bore_A", "bore_B"}, groups(), kSize, "");
  const auto open = pins.open();
  ASSERT_EQ(open.size(), 4u);  // ten components, six balances
  for (const auto& pattern : open) {
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      const Vector3d at = groups()[i].cylinder.p_LC;
      force += pattern[i].force;
      moment += pattern[i].moment + at.cross(pattern[i].force);
      EXPECT_NEAR(pattern[i].moment.z(), 0.0, 1e-15);  // turns on its pin
    }
    EXPECT_LT(force.norm(), 1e-12);
    EXPECT_LT(moment.norm(), 1e-13);
  }
  EXPECT_FALSE(pins.is_unique(0));
  EXPECT_TRUE(pins_in({"bore_A"}, groups(), kSize, "").is_unique(0));
}

// Two springs in parallel: rods of compliance 2 nm/N and 5 nm/N from C to A
// and to B. U = ½ 2e-9 A² + ½ 5e-9 (F − A)²: A takes 5/7, B takes 2/7.
TEST(HeldPins, SharesOfTwoRodsAreAsTheirStiffness) {
  const double force = 700.0;
  const LoadHistory history =
      held({"bore_A", "bore_B"}, {{"bore_C", Vector3d(force, 0.0, 0.0)}});
  const PinReactions pins = pins_in({"bore_A", "bore_B"}, groups(), kSize, "");
  const double at_A = wrench_of(history, "bore_A").force.x();
  const double at_B = wrench_of(history, "bore_B").force.x();
  const auto open = pins.open();
  Eigen::MatrixXd A(4, 4);
  Eigen::VectorXd b(4);
  for (int k = 0; k < 4; ++k) {
    const auto& first = open[static_cast<std::size_t>(k)];
    b[k] = 2e-9 * at_A * first[0].force.x() + 5e-9 * at_B * first[1].force.x();
    for (int l = 0; l < 4; ++l) {
      const auto& second = open[static_cast<std::size_t>(l)];
      A(k, l) = 2e-9 * first[0].force.x() * second[0].force.x() +
                5e-9 * first[1].force.x() * second[1].force.x();
      for (std::size_t i = 0; i < 2; ++i) {  // the others are stiff
        A(k, l) += 1e-6 * first[i].force.z() * second[i].force.z() +
                   1e-4 * first[i].moment.dot(second[i].moment);
      }
    }
  }
  const SharedPins shared =
      share(pins, history, {.mass = 0.2, .p_LCm = {0.07, 0.0, 0.0}}, kSize, 1.0,
            A, b);
  EXPECT_NEAR(wrench_of(shared.history, "bore_A").force.x(), -500.0, 1e-6);
  EXPECT_NEAR(wrench_of(shared.history, "bore_B").force.x(), -200.0, 1e-6);
  ASSERT_EQ(shared.others.size(), 2u);  // each pin softer alone gives way
  EXPECT_LT(-wrench_of(shared.others[0], "bore_A").force.x(), 499.0);
  EXPECT_GT(-wrench_of(shared.others[1], "bore_A").force.x(), 501.0);
  for (const LoadHistory& other : shared.others) {
    EXPECT_NEAR(wrench_of(other, "bore_A").force.x() +
                    wrench_of(other, "bore_B").force.x(),
                -force, 1e-9);
  }
}

}  // namespace
}  // namespace clevis::loads
