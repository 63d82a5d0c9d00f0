#include "mesh/rounds/faceted_rounds.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/quality/mass_properties.h"
#include "mesh/rounds/cylinder_groups.h"
#include "mesh/rounds/exact_geometry.h"
#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"

namespace clevis::mesh {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kInner = 0.01, kOuter = 0.03, kThickness = 0.008;

/// A ring of flat facets that no group calls round.
PartMesh<3> ring(int facets) {
  auto mesh = support::ring_mesh<3>({.inner = kInner,
                                     .outer = kOuter,
                                     .thickness = kThickness,
                                     .radial = 3,
                                     .angular = facets,
                                     .degree = 1});
  for (auto& group : mesh.groups) group.cylinder.reset();
  return mesh;
}

TEST(FacetedRounds, HoleAndRimOfARing) {
  for (const int facets : {16, 32, 128}) {
    const auto rounds = faceted_rounds(ring(facets));
    ASSERT_EQ(rounds.size(), 2u) << facets;
    for (const auto& round : rounds) {
      EXPECT_EQ(round.faces.size(), std::size_t(facets));
      EXPECT_LT(round.cylinder.p_LC.head<2>().norm(), 1e-12);
      EXPECT_NEAR(round.cylinder.length, kThickness, 1e-12);
      const bool is_hole = round.cylinder.radius < 0.02;
      EXPECT_NEAR(round.cylinder.radius, is_hole ? kInner : kOuter, 1e-12);
    }
  }
}

// gmsh makes holes of seven sides and more; a coarse rim outside is one.
TEST(FacetedRounds, CoarseHoleIsRoundCoarseRimIsNot) {
  for (const int facets : {7, 8, 12, 15}) {
    const auto rounds = faceted_rounds(ring(facets));
    ASSERT_EQ(rounds.size(), 1u) << facets;
    EXPECT_NEAR(rounds[0].cylinder.radius, kInner, 1e-12);
    EXPECT_EQ(rounds[0].faces.size(), std::size_t(facets));
  }
}

TEST(FacetedRounds, HexagonIsWhatItIs) {
  EXPECT_TRUE(faceted_rounds(ring(6)).empty());
}

TEST(FacetedRounds, RoundGroupsAreLeftToThemselves) {
  auto mesh = ring(32);
  mesh.groups[0].cylinder =
      part::Bore{Vector3d::Zero(), Vector3d::UnitZ(), kInner, kThickness};
  const auto rounds = faceted_rounds(mesh);
  ASSERT_EQ(rounds.size(), 1u);
  EXPECT_NEAR(rounds[0].cylinder.radius, kOuter, 1e-12);
}

TEST(FacetedRounds, EllipseIsNoCylinder) {
  auto mesh = ring(64);
  for (auto& v : mesh.vertices) v.x() *= 1.02;
  for (auto& points : mesh.cell_points) points.row(0) *= 1.02;
  EXPECT_TRUE(faceted_rounds(mesh).empty());
}

// Half a ring whose ends go on straight: the flats beside stay flat.
TEST(FacetedRounds, ArcEndsWhereTheFlatBegins) {
  constexpr int kFacets = 24;
  const auto map = [](const Vector3d& x) -> Vector3d {
    const double r = kInner + (kOuter - kInner) * x.x();
    const double way = x.y() * 3.0 - 1.0;  // flat, half a turn, flat
    const double z = kThickness * x.z();
    if (way < 0.0) return {r, 0.02 * way, z};
    if (way > 1.0) return {-r, -0.02 * (way - 1.0), z};
    return {r * std::cos(kPi * way), r * std::sin(kPi * way), z};
  };
  for (const auto& mesh :
       {support::structured_mesh<3>({2, 3 * kFacets, 2}, 1, map),
        support::simplex_mesh<3>({2, 3 * kFacets, 2}, 1, map)}) {
    const auto rounds = faceted_rounds(mesh);
    ASSERT_EQ(rounds.size(), 2u);
    const std::size_t each =
        2 * kFacets * (mesh.shape == CellShape::kSimplex ? 2 : 1);
    for (const auto& round : rounds) EXPECT_EQ(round.faces.size(), each);
  }
}

TEST(FacetedRounds, MeshOnThemHasTheExactVolume) {
  auto mesh = ring(16);
  const auto groups = mesh.groups.size();
  const auto boundary = mesh.boundary;
  fit_cylinder_groups(mesh, "ring");
  put_on_cylinders(mesh, faceted_rounds(mesh));
  const double exact = kPi * (kOuter * kOuter - kInner * kInner) * kThickness;
  EXPECT_NEAR(mass_properties(mesh, 1.0).mass / exact, 1.0, 1e-7);
  ASSERT_EQ(mesh.groups.size(), groups);
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    EXPECT_EQ(mesh.boundary[f].group, boundary[f].group);
  }
}

}  // namespace
}  // namespace clevis::mesh
