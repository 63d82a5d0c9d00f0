#include "stress/zones/singular_zone.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "mesh/reading/mesh_reader.h"
#include "stress/corners/boundary_corner.h"
#include "stress/zones/zone_mask.h"
#include "support/annulus_mesh.h"
#include "support/corner_mesh.h"
#include "support/source_dir.h"

namespace clevis::stress {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

mesh::PartMesh<2> square(int cells) {
  auto mesh = support::structured_mesh<2>({cells, cells}, 1,
                                          [](const Vector2d& x) -> Vector2d {
                                            return 0.02 * x;
                                          });
  mesh.thickness = 0.005;
  return mesh;
}

mesh::PartMesh<3> block(std::array<int, 3> cells) {
  return support::structured_mesh<3>(cells, 1,
                                     [](const Vector3d& x) -> Vector3d {
                                       return 0.02 * x;
                                     });
}

TEST(SingularZone, NotchOfEveryAngleHasItsExponent) {
  for (const double degrees : {200.0, 225.0, 270.0, 315.0, 360.0}) {
    const auto mesh = support::wedge_mesh(degrees / 180 * pi, 8, 0.02, 0.005);
    const auto zones = singular_zones<2>(mesh, kSteel, {});
    ASSERT_EQ(zones.size(), 1u) << degrees;
    EXPECT_LT(zones[0].at.norm(), 1e-12);
    EXPECT_EQ(zones[0].vertices, std::vector<unsigned>{0});
    if (degrees == 270.0) {
      EXPECT_NEAR(zones[0].exponent, 0.5444837, 1e-6);
    }
    if (degrees == 360.0) {
      EXPECT_NEAR(zones[0].exponent, 0.5, 1e-6);
      EXPECT_EQ(zones[0].name, "crack at (0.0, 0.0) mm");
    }
  }
}

// Beside a zone lattice points stand up to a spacing away: at its border stress
// is by what the corner's exponent says higher.
TEST(ZoneMask, PointsBesideAZoneTellItsBorder) {
  const auto mesh = support::wedge_mesh(1.5 * pi, 4, 0.02, 0.005);
  const auto zones = singular_zones<2>(mesh, kSteel, {});
  ASSERT_EQ(zones.size(), 1u);
  constexpr int kSubdivisions = 4;
  const auto discretization = elasticity::discretize<2>(mesh, 2);
  const auto beside = points_beside<2>(discretization, kSubdivisions, zones);
  ASSERT_FALSE(beside.empty());
  for (const PointBeside& point : beside) {
    const double away =
        position(discretization, point.at, kSubdivisions).norm();
    EXPECT_GT(away, zones[0].radius);
    EXPECT_NEAR(point.away, away / zones[0].radius, 1e-9);
    EXPECT_LE(point.inside_away, 1.0);
    EXPECT_NEAR(point.growth, std::pow(point.away, 1.0 - zones[0].exponent),
                1e-9);
  }
  // A field that grows like that has the same at the border from each of them.
  const auto zone_of = zone_of_points<2>(discretization, kSubdivisions, zones);
  StressHistory history;
  history.subdivisions = kSubdivisions;
  history.worst.resize(zone_of.rows(), zone_of.cols());
  for (int c = 0; c < zone_of.cols(); ++c) {
    for (int q = 0; q < zone_of.rows(); ++q) {
      const double r = position(discretization, {c, q}, kSubdivisions).norm();
      history.worst(q, c) = std::pow(std::max(r, 1e-6), zones[0].exponent - 1);
    }
  }
  history.worst_instant = Eigen::MatrixXi::Zero(zone_of.rows(), zone_of.cols());
  const auto peak = peak_outside(history, zone_of, {true}, 2);
  const double border = std::pow(zones[0].radius, zones[0].exponent - 1.0);
  EXPECT_NEAR(peak.value + excess_at_borders(history, zone_of, beside, {true},
                                             peak.value),
              border, 1e-9 * border);
  EXPECT_EQ(excess_at_borders(history, zone_of, beside, {false}, border), 0.0);
}

// sin λω = −λ sin ω: stress goes like r^-0.134, however blunt that looks.
TEST(SingularZone, KinkThatStandsAloneIsANotch) {
  const auto kink = support::wedge_mesh(194.0 / 180 * pi, 4, 0.02, 0.005);
  const auto zones = singular_zones<2>(kink, kSteel, {});
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_NEAR(zones[0].exponent, 0.8655326, 1e-6);
  const auto blunt = support::wedge_mesh(184.0 / 180 * pi, 4, 0.02, 0.005);
  EXPECT_TRUE(singular_zones<2>(blunt, kSteel, {}).empty());
}

TEST(SingularZone, ConvexPlateAndFacetsOfACurveHaveNone) {
  EXPECT_TRUE(singular_zones<2>(square(3), kSteel, {}).empty());
  // Facets of 11° around a hole.
  const auto ring = support::ring_mesh<2>(
      {.inner = 0.005, .outer = 0.02, .radial = 3, .angular = 32, .degree = 1});
  EXPECT_TRUE(singular_zones<2>(ring, kSteel, {}).empty());
}

// Its two corners stand one cell apart, alike, and make no curve; three do.
TEST(SingularZone, GrooveOfOneCellHasTwoNotches) {
  const auto strip = [](int level_cells) {
    const int cells = 4 + level_cells;
    auto mesh = support::structured_mesh<2>(
        {cells, 2}, 1, [&](const Vector2d& x) -> Vector2d {
          const double at = cells * x.x();
          const double lift =
              std::clamp(std::min(at - 1.0, cells - 1.0 - at), 0.0, 1.0);
          return 1e-3 * Vector2d(at, lift * (1.0 - x.y()) + 4.0 * x.y());
        });
    mesh.thickness = 0.005;
    return mesh;
  };
  EXPECT_EQ(singular_zones<2>(strip(1), kSteel, {}).size(), 2u);
  EXPECT_EQ(singular_zones<2>(strip(2), kSteel, {}).size(), 2u);
}

/// Strip with a round groove, straight flanks and one cell of the second degree
/// over its arc.
/// @param turn  of the arc [rad].
/// @param middle  of the cell, from that of the arc [1].
/// @param kink  between arc and first flank [rad].
mesh::PartMesh<2> round_groove(double turn, double middle, double kink) {
  const auto on_arc = [&](double t) -> Vector2d {
    const double angle = turn * (t - 0.5 + middle * 4.0 * t * (1.0 - t));
    return {std::sin(angle), std::cos(angle)};
  };
  const auto profile = [&](double x) -> Vector2d {
    if (x >= 1.0 && x <= 2.0) return on_arc(x - 1.0);
    const double slope = x < 1.0 ? 0.5 * turn + kink : -0.5 * turn;
    return on_arc(x < 1.0 ? 0.0 : 1.0) +
           (x < 1.0 ? x - 1.0 : x - 2.0) *
               Vector2d(std::cos(slope), std::sin(slope));
  };
  auto mesh = support::structured_mesh<2>(
      {3, 2}, 2, [&](const Vector2d& x) -> Vector2d {
        const Vector2d below = profile(3.0 * x.x());
        return 2e-3 * (below + x.y() * Vector2d(0.0, 4.0 - below.y()));
      });
  mesh.thickness = 0.005;
  return mesh;
}

// A mesher's cell over an arc of 60° with its middle node 5° off kinks by 8.6°
// at one end and by as much the other way at the other.
TEST(SingularZone, EndOfACurvedCellIsNoNotch) {
  EXPECT_TRUE(
      singular_zones<2>(round_groove(pi / 3, 0.08, 0.0), kSteel, {}).empty());
}

// A fillet that does not meet its flank: kinks of what cells cannot leave.
TEST(SingularZone, ArcThatMeetsItsFlankAtAnAngleIsANotch) {
  const double kink = 12.0 / 180.0 * pi;
  EXPECT_EQ(
      singular_zones<2>(round_groove(pi / 6, 0.0, kink), kSteel, {}).size(),
      1u);
}

// 12 facets round a hole kink by 30 degrees each.
TEST(SingularZone, CoarseHoleHasNone) {
  const auto ring = support::structured_mesh<2>(
      {2, 12}, 1, [](const Vector2d& x) -> Vector2d {
        const double r = 0.01 * (1.0 + x.x()), angle = 1.5 * pi * x.y();
        return {r * std::cos(angle), r * std::sin(angle)};
      });
  EXPECT_TRUE(singular_zones<2>(ring, kSteel, {}).empty());
}

TEST(SingularZone, ClampHasItsTwoEnds) {
  const auto zones =
      singular_zones<2>(square(3), kSteel, {{"x0", {true, true, false}}});
  ASSERT_EQ(zones.size(), 2u);
  EXPECT_EQ(zones[0].name, "edge of x0 at (0.0, 0.0) mm");
  EXPECT_EQ(zones[1].name, "edge of x0 at (0.0, 20.0) mm");
  // A tenth of the diagonal.
  EXPECT_NEAR(zones[0].radius, 0.1 * std::sqrt(2.0) * 0.02, 1e-12);
}

// Corners of a small part are told apart by their names.
TEST(SingularZone, SmallPartsHaveMoreDigits) {
  auto mesh =
      support::structured_mesh<2>({2, 2}, 1, [](const Vector2d& x) -> Vector2d {
        return 40e-6 * x;
      });
  mesh.thickness = 10e-6;
  const auto zones =
      singular_zones<2>(mesh, kSteel, {{"x0", {true, true, false}}});
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_EQ(zones[0].name, "edge of x0 at (0.0000, 0.0000) mm");
  EXPECT_EQ(zones[1].name, "edge of x0 at (0.0000, 0.0400) mm");
}

// A groove in the side beside a clamp, whatever its group is called: the zone
// at the clamp's end must not swallow its peak.
TEST(SingularZone, EndsHalfWayToAGroove) {
  constexpr double kAt = 0.15, kHalf = 0.05, kDepth = 0.1;  // of the side
  const auto grooved = [&](double depth) {
    return support::structured_mesh<2>(
        {40, 4}, 2, [&](const Vector2d& x) -> Vector2d {
          const double s = (x.x() - kAt) / kHalf;
          const double groove =
              std::abs(s) < 1.0 ? depth * 0.5 * (1.0 + std::cos(pi * s)) : 0.0;
          return {0.02 * x.x(), 0.02 * x.y() * (1.0 - groove)};
        });
  };
  const auto end = [](const mesh::PartMesh<2>& mesh) {
    const auto zones =
        singular_zones<2>(mesh, kSteel, {{"x0", {true, true, false}}});
    return *std::ranges::find_if(zones, [](const SingularZone& zone) {
      return zone.at.y() > 0.01;
    });
  };
  EXPECT_NEAR(end(grooved(0.0)).radius, 0.1 * std::sqrt(2.0) * 0.02, 1e-12);
  EXPECT_LT(end(grooved(kDepth)).radius, 0.5 * kAt * 0.02);
  EXPECT_GT(end(grooved(kDepth)).radius, 0.3 * (kAt - kHalf) * 0.02);
}

TEST(SingularZone, RollersOnPlanesOfSymmetryHaveNone) {
  EXPECT_TRUE(singular_zones<2>(
                  square(3), kSteel,
                  {{"x0", {true, false, false}}, {"y0", {false, true, false}}})
                  .empty());
  // Held along itself a side is no plane of symmetry, but smooth at 90° too.
  EXPECT_TRUE(
      singular_zones<2>(square(3), kSteel, {{"x0", {false, true, false}}})
          .empty());
}

TEST(SingularZone, SupportThatEndsOnAStraightSideIsSingular) {
  auto mesh = square(4);
  mesh.groups.push_back({"half", {}});
  for (auto& face : mesh.boundary) {
    if (face.group == 2 && face.cell % 4 < 2) face.group = 4;
  }
  const auto clamped =
      singular_zones<2>(mesh, kSteel, {{"half", {true, true, false}}});
  ASSERT_EQ(clamped.size(), 2u);
  EXPECT_NEAR(clamped[1].exponent, 0.5, 1e-6);
  const auto rolling =
      singular_zones<2>(mesh, kSteel, {{"half", {false, true, false}}});
  ASSERT_EQ(rolling.size(), 1u);
  EXPECT_NEAR(rolling[0].exponent, 0.5, 1e-6);
  EXPECT_NEAR(rolling[0].at.x(), 0.01, 1e-12);
}

TEST(SingularZone, ClampedBlockHasOneClosedEdge) {
  const auto zones =
      singular_zones<3>(block({3, 3, 3}), kSteel, {{"x0", {true, true, true}}});
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_NEAR(zones[0].exponent, 0.711173, 1e-6);
  EXPECT_EQ(zones[0].edges.size(), 12u);
  EXPECT_EQ(zones[0].name.substr(0, 10), "edge of x0");
  EXPECT_NEAR(distance(zones[0], Vector3d(0.01, 0.0, 0.01)), 0.01, 1e-12);
  EXPECT_NEAR(distance(zones[0], Vector3d(0.003, 0.004, 0.01)), 0.005, 1e-12);
}

TEST(SingularZone, ReentrantEdgeOfASolidIsANotch) {
  const std::array<int, 3> cells = {4, 4, 2};
  const auto mesh = support::without_cells<3>(block(cells), cells,
                                              [](const std::array<int, 3>& c) {
                                                return c[0] < 2 || c[1] < 2;
                                              });
  const auto zones = singular_zones<3>(mesh, kSteel, {});
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_NEAR(zones[0].exponent, 0.5444837, 1e-6);
  EXPECT_EQ(zones[0].edges.size(), 2u);
  EXPECT_EQ(zones[0].name, "notch at (10.0, 10.0, 15.0) mm");
}

TEST(SingularZone, RollersOfABlockHaveNone) {
  EXPECT_TRUE(singular_zones<3>(block({2, 2, 2}), kSteel,
                                {{"x0", {true, false, false}},
                                 {"y0", {false, true, false}},
                                 {"z0", {false, false, true}}})
                  .empty());
}

// Every part of the landing gear is rounded: no zone on any of them.
TEST(SingularZone, PartsOfTheLandingGearHaveNone) {
  for (const char* name :
       {"link_ab", "link_bc", "link_dce", "cylinder_body", "rod"}) {
    const auto mesh =
        mesh::read_part_mesh(support::source_dir().string() +
                                 "/meshes/landing_gear/" + name + ".msh",
                             1e-3);
    for (const auto& zone : singular_zones<3>(mesh, kSteel, {})) {
      ADD_FAILURE() << name << ": " << zone.name << " " << zone.exponent;
    }
  }
}

TEST(BoundaryCorner, AngleComesFromTheCurvedTangents) {
  // Bore against a cut: 90° however coarse.
  const auto mesh = support::sector_mesh<2>(
      {.inner = 0.01, .outer = 0.03, .radial = 1, .angular = 1});
  for (const auto& corner : boundary_corners<2>(mesh)) {
    EXPECT_NEAR(corner.angle, pi / 2, 0.01);
  }
}

}  // namespace
}  // namespace clevis::stress
