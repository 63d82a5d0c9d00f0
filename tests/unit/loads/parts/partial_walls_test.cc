#include "loads/parts/partial_walls.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 5e-3, kLength = 10e-3;  // [m]

/// A bore about z, open on both sides of +x over half an angle.
struct OpenBore {
  explicit OpenBore(double gap) {
    constexpr int kAround = 3600, kAlong = 4;
    group.name = "bore_A";
    group.is_cylinder = true;
    group.cylinder = {.p_LC = Vector3d::Zero(),
                      .axis_L = Vector3d::UnitZ(),
                      .radius = kRadius,
                      .length = kLength};
    std::vector<Vector3d> normals;
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * kPi * (k + 0.5) / kAround - kPi;
      if (std::abs(angle) < gap) continue;
      normals.push_back({std::cos(angle), std::sin(angle), 0.0});
    }
    const double area =
        2.0 * kPi * kRadius * kLength / (double{kAround} * kAlong);
    const auto n = static_cast<Index>(normals.size());
    wall.points.resize(3, n * kAlong);
    wall.areas.resize(3, n * kAlong);
    for (Index q = 0; q < n * kAlong; ++q) {
      const Vector3d& e_r = normals[static_cast<std::size_t>(q % n)];
      const double s =
          kLength * ((static_cast<double>(q / n) + 0.5) / kAlong - 0.5);
      wall.points.col(q) = kRadius * e_r + s * Vector3d::UnitZ();
      wall.areas.col(q) = -area * e_r;
      group.area += area;
      group.area_vector -= area * e_r;
      group.normal_square += area * e_r * e_r.transpose();
    }
    wall.spans = {{-kLength / 2, kLength / 2}};
  }

  /// Notes of a force [N].
  std::vector<std::string> notes(const Vector3d& force) const {
    LoadHistory history;
    history.seats = {{.name = "A",
                      .group = "bore_A",
                      .kind = SeatKind::kBearing,
                      .p_LS = Vector3d::Zero()}};
    InstantLoad instant;
    instant.label = "pull";
    instant.wrenches = {{.force = force}};
    history.instants = {instant};
    note_partial_walls(
        {group},
        [this](const GroupGeometry&) {
          return wall;
        },
        "part P", history);
    return history.notes;
  }

  std::string code(const Vector3d& force) const {
    try {
      notes(force);
    } catch (const Error& error) {
      return error.code();
    }
    return "none";
  }

  GroupGeometry group;
  PartialWall wall;
};

// 2 F / (pi r l) all round, cos g F / (r l (pi/2 - g - sin 2g / 2)) before a
// gap of half-angle g.
TEST(PartialWalls, NoteHasShareAndPressures) {
  const double gap = 0.3;
  const auto notes = OpenBore(gap).notes({1000.0, 0.0, 0.0});
  ASSERT_EQ(notes.size(), 1u);
  const double whole = 2.0 * 1000.0 / (kPi * kRadius * kLength);
  const double open =
      1000.0 * std::cos(gap) /
      (kRadius * kLength * (0.5 * kPi - gap - 0.5 * std::sin(2.0 * gap)));
  EXPECT_NEAR(open / whole, 1.52, 0.01);
  EXPECT_EQ(notes[0],
            "A presses on \"bore_A\", of whose wall 90.4 % is there: pressure "
            "reaches 19.33 MPa (pull), all round it would reach 12.73 MPa");
  EXPECT_NEAR(open, 19.33e6, 0.005e6);
}

TEST(PartialWalls, RefusedWhereTooLittleCarries) {
  EXPECT_EQ(OpenBore(0.45).code({1000.0, 0.0, 0.0}), "none");
  EXPECT_EQ(OpenBore(0.50).code({1000.0, 0.0, 0.0}), "L002");
  EXPECT_EQ(OpenBore(0.50).code({-1000.0, 0.0, 0.0}), "none");
  // A saddle takes what presses into it.
  EXPECT_EQ(OpenBore(0.75 * kPi).code({-1000.0, 0.0, 0.0}), "none");
  EXPECT_EQ(OpenBore(0.75 * kPi).code({1000.0, 0.0, 0.0}), "L002");
  // Loads along the axis press nowhere.
  EXPECT_EQ(OpenBore(0.75 * kPi).code({0.0, 0.0, 0.0}), "none");
}

TEST(PartialWalls, WholeWallsHaveNoNote) {
  EXPECT_TRUE(OpenBore(0.01).notes({1000.0, 0.0, 0.0}).empty());
}

}  // namespace
}  // namespace clevis::loads
