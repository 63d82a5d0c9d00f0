#include "loads/parts/series_loads.h"

#include <algorithm>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

const Vector3d kMiddle(0.1, 0.0, 0.0);

part::MassProperties mass() {
  return {.mass = 2.0,
          .p_LCm = kMiddle,
          .inertia_LCm = Vector3d(1e-4, 2e-4, 3e-4).asDiagonal()};
}

std::vector<GroupGeometry> groups() {
  GroupGeometry bore;
  bore.name = "bore_A";
  bore.is_cylinder = true;
  bore.cylinder = {.p_LC = {0.2, 0.0, 0.0},
                   .axis_L = Vector3d::UnitZ(),
                   .radius = 5e-3,
                   .length = 10e-3};
  bore.centroid = bore.cylinder.p_LC;
  bore.area = 2.0 * std::numbers::pi * 5e-3 * 10e-3;
  GroupGeometry face;
  face.name = "end";
  face.centroid = {0.0, 0.0, 0.0};
  face.area = 1e-4;
  face.area_vector = {-1e-4, 0.0, 0.0};
  return {bore, face};
}

part::LoadSeries series() {
  part::LoadSeries series;
  series.name = "bench";
  series.place = "scene.toml:9:1";
  series.seats = {
      {.name = "A", .group = "bore_A", .about = Vector3d(0.2, 0.0, 3e-3)},
      {.name = "push", .group = "end", .is_face = true}};
  series.pressurized = {"end"};
  part::SeriesInstant instant;
  instant.time = 0.5;
  instant.forces = {{0.0, 40.0, 0.0}, {30.0, 0.0, 0.0}};
  instant.moments = {Vector3d::Zero(), Vector3d::Zero()};
  instant.pressures = {1e5};  // 10 N along x
  series.instants = {instant};
  return series;
}

part::PartDefinition part_definition() {
  part::PartDefinition part;
  part.name = "P";
  return part;
}

// A force across the end face, whose moment about its middle says where.
TEST(SeriesLoads, TellForcesThatTravel) {
  part::LoadSeries series = loads::series();
  part::SeriesInstant& first = series.instants[0];
  first.forces[1] = {30.0, 0.0, 0.0};
  series.instants.push_back(first);
  const auto notes_at = [&](double moment) {
    series.instants[1].time = 0.6;
    series.instants[1].moments[1] = {0.0, 0.0, moment};
    return series_loads(part_definition(), series, groups(), mass()).notes;
  };
  const auto travels = [](const std::string& note) {
    return note.find("travels") != std::string::npos;
  };
  // The face is 10 mm wide: 1.9 and 2.1 mm.
  EXPECT_TRUE(std::ranges::none_of(notes_at(30.0 * 1.9e-3), travels));
  const auto notes = notes_at(30.0 * 2.1e-3);
  const auto note = std::ranges::find_if(notes, travels);
  ASSERT_NE(note, notes.end());
  EXPECT_NE(note->find("\"push\" travels by 2.1 mm on \"end\" (10 mm)"),
            std::string::npos)
      << *note;
  // A moment, not a place: off the face.
  EXPECT_TRUE(std::ranges::none_of(notes_at(30.0 * 6.1e-3), travels));
}

TEST(SeriesLoads, MomentsMoveToTheMiddleOfTheBore) {
  const LoadHistory history =
      series_loads(part_definition(), series(), groups(), mass());
  ASSERT_EQ(history.seats.size(), 2u);
  EXPECT_EQ(history.seats[0].kind, SeatKind::kBearing);
  EXPECT_EQ(history.seats[1].kind, SeatKind::kTraction);
  // r × f of a force along y, 3 mm above the middle.
  const Wrench& pin = history.instants[0].wrenches[0];
  EXPECT_NEAR((pin.moment - Vector3d(-0.12, 0.0, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(history.instants[0].time, 0.5);
  EXPECT_EQ(history.instants[0].label, "bench, t = 0.5 s");
}

TEST(SeriesLoads, InertiaBalancesLoadsWithoutAccelerations) {
  const LoadHistory history =
      series_loads(part_definition(), series(), groups(), mass());
  const RigidAcceleration& rigid = history.instants[0].rigid;
  // 40 N along x by force and pressure, 40 N along y at 0.1 m from the middle.
  EXPECT_NEAR(rigid.alpha.z(), 40.0 * 0.1 / 3e-4, 1e-6);
  const Vector3d of_middle = rigid.acceleration + rigid.alpha.cross(kMiddle);
  EXPECT_NEAR((of_middle - Vector3d(20.0, 20.0, 0.0)).norm(), 0.0, 1e-9);
  const Wrench left = residual(history, history.instants[0], mass());
  EXPECT_NEAR(left.force.norm(), 0.0, 1e-9);
  EXPECT_NEAR(left.moment.norm(), 0.0, 1e-9);
  ASSERT_EQ(history.notes.size(), 2u);
  EXPECT_NE(history.notes[0].find("28.28 m/s^2"), std::string::npos);
  EXPECT_TRUE(history.notes[1].starts_with("what holds the part is not in"));
}

TEST(SeriesLoads, GivenAccelerationsLeaveASmallRestOnly) {
  part::LoadSeries given = series();
  given.has_acceleration = true;
  given.largest_imbalance = 0.01;
  const RigidAcceleration exact =
      series_loads(part_definition(), series(), groups(), mass())
          .instants[0]
          .rigid;
  given.instants[0].acceleration = exact.acceleration;
  given.instants[0].angular_acceleration = 1.005 * exact.alpha;
  given.instants[0].acceleration -=
      (0.005 * exact.alpha).cross(kMiddle);  // turns about the middle
  const LoadHistory history =
      series_loads(part_definition(), given, groups(), mass());
  EXPECT_NEAR(history.instants[0].rigid.alpha.z(), exact.alpha.z(), 1e-6);
  EXPECT_NEAR(history.instants[0].relief.moment.z(), -0.02, 1e-9);
  given.instants[0].acceleration *= 1.1;
  try {
    series_loads(part_definition(), given, groups(), mass());
    FAIL() << "a tenth of the acceleration is missing";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "L001");
  }
}

TEST(SeriesLoads, SupportsTakeWhatTheLoadsLeave) {
  part::LoadSeries held = series();
  held.fixed["end"] = {true, true, true};
  const LoadHistory history =
      series_loads(part_definition(), held, groups(), mass());
  EXPECT_EQ(history.instants[0].rigid.acceleration, Vector3d::Zero());
  EXPECT_TRUE(history.notes.empty());
  held.fixed["none"] = {true, false, false};
  EXPECT_THROW(series_loads(part_definition(), held, groups(), mass()), Error);
}

}  // namespace
}  // namespace clevis::loads
