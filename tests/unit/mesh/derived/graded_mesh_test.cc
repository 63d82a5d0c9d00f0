#include "mesh/derived/graded_mesh.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "mesh/quality/mass_properties.h"
#include "support/annulus_mesh.h"

namespace clevis::mesh {
namespace {

PartMesh<2> quarter_ring(int radial, int angular) {
  return support::sector_mesh<2>({.inner = 0.01,
                                  .outer = 0.03,
                                  .thickness = 0.004,
                                  .radial = radial,
                                  .angular = angular});
}

/// Every edge has two cells, or one and a boundary face.
void expect_conforming(const PartMesh<2>& mesh) {
  std::map<std::pair<unsigned, unsigned>, int> sides;
  for (const auto& cell : mesh.cells) {
    for (const auto& [a, b] : {std::pair(0, 1), {1, 3}, {3, 2}, {2, 0}}) {
      const auto edge = std::minmax(cell[static_cast<std::size_t>(a)],
                                    cell[static_cast<std::size_t>(b)]);
      ++sides[{edge.first, edge.second}];
    }
  }
  const auto single = std::ranges::count_if(sides, [](const auto& side) {
    EXPECT_LE(side.second, 2);
    return side.second == 1;
  });
  EXPECT_EQ(single, static_cast<long>(mesh.boundary.size()));
}

/// Length of a group's faces by their end points.
double length_of(const PartMesh<2>& mesh, const std::string& name) {
  double length = 0.0;
  for (const auto& face : mesh.boundary) {
    if (face.group < 0 ||
        mesh.groups[static_cast<std::size_t>(face.group)].name != name) {
      continue;
    }
    const auto& cell = mesh.cells[static_cast<std::size_t>(face.cell)];
    const std::size_t bit = face.face < 2 ? 2 : 1;  // along the face
    const std::size_t from = face.face % 2 == 0 ? 0 : 3 - bit;
    length +=
        (mesh.vertices[cell[from]] - mesh.vertices[cell[from + bit]]).norm();
  }
  return length;
}

TEST(GradedMesh, KeepsShapeGroupsAndConformity) {
  const auto mesh = quarter_ring(3, 4);
  const double mass = mass_properties(mesh, 7850.0).mass;
  const auto graded = grade_at_vertices(mesh, {0, 5, 19}, 6);
  expect_conforming(graded.mesh);
  EXPECT_NEAR(mass_properties(graded.mesh, 7850.0).mass, mass, 1e-12 * mass);
  EXPECT_NEAR(length_of(graded.mesh, "y0"), 0.02, 1e-15);
  EXPECT_NEAR(length_of(graded.mesh, "y1"), 0.02, 1e-15);
  EXPECT_GT(std::ranges::count(graded.vertex_of, 1), 0);
}

TEST(GradedMesh, RingsShrinkGeometrically) {
  constexpr int kLayers = 5;
  const auto graded = grade_at_vertices(quarter_ring(2, 2), {4}, kLayers);
  std::vector<double> reach(kLayers + 1, 0.0);
  for (std::size_t c = 0; c < graded.ring.size(); ++c) {
    if (graded.ring[c] < 0) continue;
    auto& r = reach[static_cast<std::size_t>(graded.ring[c])];
    for (const unsigned v : graded.mesh.cells[c]) {
      r = std::max(r, (graded.mesh.vertices[v] -
                       graded.mesh.vertices[graded.vertices[0]])
                          .norm());
    }
  }
  for (std::size_t k = 2; k < reach.size(); ++k) {
    EXPECT_NEAR(reach[k] / reach[k - 1], kGradingRatio, 0.02) << k;
  }
}

// One cell between two of the vertices: halved first.
TEST(GradedMesh, TwoVerticesOfOneCellAreParted) {
  const auto graded = grade_at_vertices(quarter_ring(1, 3), {0, 1}, 3);
  expect_conforming(graded.mesh);
  EXPECT_EQ(graded.vertices, (std::vector<unsigned>{0, 1}));
  EXPECT_EQ(std::ranges::count(graded.ring, 3), 2);
}

TEST(GradedMesh, HalvedCellsKeepTheirShape) {
  const auto mesh = quarter_ring(2, 3);
  const auto halved = halve_cells(mesh);
  expect_conforming(halved);
  EXPECT_EQ(halved.cells.size(), 4 * mesh.cells.size());
  const auto before = mass_properties(mesh, 1.0);
  const auto after = mass_properties(halved, 1.0);
  EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
  EXPECT_LT((after.p_LCm - before.p_LCm).norm(), 1e-14);
}

}  // namespace
}  // namespace clevis::mesh
