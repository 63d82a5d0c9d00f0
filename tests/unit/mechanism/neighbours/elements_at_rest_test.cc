// Force elements of a mechanism at rest: friction as drives and as springs that
// break away, gas that flows and takes heat.
#include "mechanism/neighbours/elements_at_rest.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism/mass_matrix/centre_frame.h"
#include "mechanism/neighbours/neighbours.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::pin;
using testing::uniform_bar;

Instant placed(const MechanismDefinition& m) {
  Instant instant;
  for (const BodyDefinition& body : m.bodies) {
    instant.bodies.push_back({.pose = body.placement});
  }
  instant.joints.resize(m.joints.size());
  instant.elements.resize(m.elements.size());
  return instant;
}

/// A level bar of 1 m on a pin of the ground, with two brakes on it.
MechanismDefinition bar_with_brakes(const FrictionLaw& law) {
  MechanismDefinition m;
  m.bodies = {uniform_bar("bar", Vector3d::Zero(), 0.0, 1.0)};
  m.joints = {pin("O", kGround, 0, 0.0, 0.0)};
  m.dimension = SpaceDimension::kPlanar;
  LineElement brake;
  brake.name = "brake";
  brake.law = law;
  brake.line.joint = 0;
  m.elements = {brake, brake};
  return m;
}

double stiffness_of(const MechanismDefinition& m, std::size_t element) {
  const auto& line = std::get<LineElement>(m.elements[element]);
  return std::get<SpringLaw>(line.law).stiffness;
}

// None where the pin moves, where a drive holds it already, or where the first
// of two does.
TEST(ElementsAtRest, HoldsAsADriveOnce) {
  MechanismDefinition m = bar_with_brakes({});
  Instant instant = placed(m);
  const Sticking found = sticking(m, instant);
  ASSERT_EQ(found.coordinates.size(), 1U);
  EXPECT_EQ(found.coordinates[0].joint, 0);
  EXPECT_TRUE(found.lines.empty());
  instant.elements[0].rate = instant.elements[1].rate = 1e-3;
  EXPECT_TRUE(sticking(m, instant).coordinates.empty());
  instant.elements[0].rate = instant.elements[1].rate = 0.0;
  DriveDefinition drive;
  drive.joint = 0;
  m.drives = {drive};
  EXPECT_TRUE(sticking(m, instant).coordinates.empty());
}

// Across the bar it holds its turn; along it the pin does already, and behind
// the first one another.
TEST(ElementsAtRest, HoldsItsLineBetweenPoints) {
  MechanismDefinition m = bar_with_brakes({});
  for (ForceElement& element : m.elements) {
    ElementLine& line = std::get<LineElement>(element).line;
    line.kind = ElementLine::Kind::kSlide;
    line.a = {kGround, Vector3d(1.0, -1.0, 0.0)};
    line.b = {0, Vector3d(1.0, 0.0, 0.0)};
    line.axis_L = Vector3d::UnitY();
  }
  const Instant instant = placed(m);
  Sticking found = sticking(m, instant);
  EXPECT_TRUE(found.coordinates.empty());
  EXPECT_EQ(found.lines, std::vector<std::size_t>{0});
  Neighbours neighbours(m, 0);
  const Eigen::Index rows = neighbours.rows(instant).body.rows();
  neighbours.hold_along(0);
  const NeighbourRows held = neighbours.rows(instant);
  ASSERT_EQ(held.body.rows(), rows + 1);
  EXPECT_EQ(held.places[held.place_of.back()], (NeighbourPlace{-1, false, 0}));
  // At the tip, 0.5 m from the centre of mass, by turns times the length.
  const double length = neighbours.frame().length;
  const auto along = held.body.bottomRows(1);
  EXPECT_NEAR(along(0, 1), 1.0, 1e-12);
  EXPECT_NEAR(along(0, 5), 0.5 / length, 1e-12);
  EXPECT_NEAR(along.norm(), std::hypot(1.0, 0.5 / length), 1e-12);
  for (ForceElement& element : m.elements) {
    std::get<LineElement>(element).line.axis_L = Vector3d::UnitX();
  }
  found = sticking(m, instant);
  EXPECT_TRUE(found.lines.empty());
}

// 3 N m less what they bear already, over 1/200 rad; each by itself.
TEST(ElementsAtRest, YieldsByWhatItBearsBeyondItsEffort) {
  const MechanismDefinition m =
      bar_with_brakes({.breakaway = 3.0, .kinetic = 2.0});
  Instant instant = placed(m);
  instant.elements[1].effort = -1.0;
  auto yielding = yielding_at_rest(m, instant);
  ASSERT_TRUE(yielding);
  EXPECT_NEAR(stiffness_of(*yielding, 0), 600.0, 1e-9);
  EXPECT_NEAR(stiffness_of(*yielding, 1), 400.0, 1e-9);
  instant.elements[1].effort = 3.1;
  yielding = yielding_at_rest(m, instant);
  EXPECT_EQ(stiffness_of(*yielding, 1), 0.0);
  instant.elements[0].rate = instant.elements[1].rate = 1e-3;
  EXPECT_FALSE(yielding_at_rest(m, instant));
}

// 2 mm times the force across the axis, whatever acts along it.
TEST(ElementsAtRest, FollowsTheForceAcrossTheAxis) {
  const MechanismDefinition m =
      bar_with_brakes({.breakaway = 2e-3, .follows_reaction = true});
  Instant instant = placed(m);
  instant.joints[0].f_W = {300.0, 400.0, 700.0};
  const auto yielding = yielding_at_rest(m, instant);
  ASSERT_TRUE(yielding);
  EXPECT_NEAR(stiffness_of(*yielding, 0), 200.0, 1e-9);
}

// Bristles are softer than what the sway asks for, or break away before.
TEST(ElementsAtRest, BristlesHoldNoMoreThanTheyBear) {
  FrictionLaw law{.model = FrictionModel::kLuGre,
                  .breakaway = 3.0,
                  .kinetic = 3.0,
                  .bristle_stiffness = 1e5};
  MechanismDefinition m = bar_with_brakes(law);
  auto yielding = yielding_at_rest(m, placed(m));
  ASSERT_TRUE(yielding);
  EXPECT_NEAR(stiffness_of(*yielding, 0), 600.0, 1e-9);
  law.bristle_stiffness = 50.0;
  m = bar_with_brakes(law);
  yielding = yielding_at_rest(m, placed(m));
  EXPECT_NEAR(stiffness_of(*yielding, 0), 50.0, 1e-9);
}

// A slide gives way by 1/200 of the mechanism's length.
TEST(ElementsAtRest, OnASlideTheMechanismsLengthCounts) {
  MechanismDefinition m = bar_with_brakes({.breakaway = 3.0, .kinetic = 3.0});
  m.joints[0].type = JointType::kPrismatic;
  const auto yielding = yielding_at_rest(m, placed(m));
  ASSERT_TRUE(yielding);
  EXPECT_NEAR(stiffness_of(*yielding, 0), 600.0 / frame_at_centres(m).length,
              1e-9);
}

// What creeps holds nothing, and is left as it is.
TEST(ElementsAtRest, RegularizedFrictionIsNone) {
  const MechanismDefinition m =
      bar_with_brakes({.model = FrictionModel::kRegularized,
                       .breakaway = 3.0,
                       .kinetic = 3.0,
                       .regularizing_speed = 1e-3});
  EXPECT_FALSE(yielding_at_rest(m, placed(m)));
}

constexpr double kPressure = 5e5, kArea = 1e-3, kVolume = 1e-4;
constexpr double kIsothermal = kPressure * kArea * kArea / kVolume;  // [N/m]

/// A sealed chamber on the bar, as it is changed.
MechanismDefinition bar_on_gas(GasChamber chamber) {
  MechanismDefinition m = bar_with_brakes({});
  chamber.area = kArea;
  LineElement gas;
  gas.line.kind = ElementLine::Kind::kDistance;
  gas.line.a = {kGround, {0.5, 1.0, 0.0}};
  gas.line.b = {0, {0.5, 0.0, 0.0}};
  gas.law = GasCylinderLaw{.chambers = {std::move(chamber)}};
  m.elements = {gas};
  return m;
}

std::optional<MechanismDefinition> yielding_gas(const GasChamber& chamber) {
  const MechanismDefinition m = bar_on_gas(chamber);
  Instant instant = placed(m);
  instant.t = 1.0;
  instant.elements[0].chambers = {{.volume = kVolume, .pressure = kPressure}};
  return yielding_at_rest(m, instant);
}

TEST(ElementsAtRest, GasTakesHeat) {
  EXPECT_FALSE(yielding_gas({.heat = ChamberHeat::kInsulated}));
  EXPECT_FALSE(yielding_gas({.heat = ChamberHeat::kIsothermal}));
  const auto yielding = yielding_gas({.heat = ChamberHeat::kConducting});
  ASSERT_TRUE(yielding);
  EXPECT_NEAR(stiffness_of(*yielding, 0), kIsothermal, 1e-9 * kIsothermal);
}

// An open valve keeps the pressure; one that has shut by then seals.
TEST(ElementsAtRest, GasFlowsThroughAnOpenValve) {
  GasValve valve{.times = {0.0, 0.5}, .signals = {1.0, 0.0}};
  EXPECT_FALSE(yielding_gas({.valve = valve}));
  valve.signals = {0.0, -0.2};
  const auto yielding = yielding_gas({.valve = valve});
  ASSERT_TRUE(yielding);
  EXPECT_EQ(stiffness_of(*yielding, 0), 0.0);
}

}  // namespace
}  // namespace clevis::mechanism
