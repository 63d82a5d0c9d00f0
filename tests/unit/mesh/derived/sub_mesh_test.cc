#include "mesh/derived/sub_mesh.h"

#include <gtest/gtest.h>

#include "support/simplex_mesh.h"

namespace clevis::mesh {
namespace {

using Eigen::Vector3d;

PartMesh<3> bar() {
  return support::simplex_mesh<3>({4, 1, 1}, 2, [](const Vector3d& x) {
    return Vector3d(4.0 * x[0], x[1], x[2]);
  });
}

double volume_of_corners(const PartMesh<3>& mesh) {
  double volume = 0.0;
  for (const auto& ids : mesh.cells) {
    Eigen::Matrix3d edges;
    for (std::size_t k = 0; k < 3; ++k) {
      edges.col(static_cast<Eigen::Index>(k)) =
          mesh.vertices[ids[k + 1]] - mesh.vertices[ids[0]];
    }
    volume += edges.determinant() / 6.0;
  }
  return volume;
}

// Six tetrahedra a cube, cubes along x: the second cube alone.
TEST(SubMesh, KeepsShapeAndGroupsOfItsCells) {
  const auto whole = bar();
  const auto sub = sub_mesh<3>(whole, {6, 7, 8, 9, 10, 11});
  ASSERT_EQ(sub.mesh.cells.size(), 6U);
  EXPECT_EQ(sub.mesh.vertices.size(), 8U);
  EXPECT_NEAR(volume_of_corners(sub.mesh), 1.0, 1e-14);
  for (const auto& vertex : sub.mesh.vertices) {
    EXPECT_GE(vertex[0], 1.0);
    EXPECT_LE(vertex[0], 2.0);
  }
  EXPECT_EQ(sub.cells[3], 9);
  EXPECT_EQ(sub.mesh.cell_points[3], whole.cell_points[9]);
  // Two triangles on each of its four outer sides, none at x = 1 and x = 2.
  EXPECT_EQ(sub.mesh.boundary.size(), 8U);
  for (const auto& face : sub.mesh.boundary) {
    EXPECT_NE(sub.mesh.groups[static_cast<std::size_t>(face.group)].name[0],
              'x');
  }
}

TEST(SubMesh, NeighboursAreThoseThatShareAVertexLayerByLayer) {
  const auto whole = bar();
  const auto cubes = [&](int first, int last) {
    std::vector<int> cells;
    for (int c = 6 * first; c < 6 * (last + 1); ++c) cells.push_back(c);
    return cells;
  };
  // All tetrahedra of Kuhn's cube touch its diagonal's ends, on both sides.
  EXPECT_EQ(with_neighbours(whole, cubes(0, 0)), cubes(0, 1));
  EXPECT_EQ(with_neighbours(whole, cubes(0, 0), 2), cubes(0, 2));
  EXPECT_EQ(with_neighbours(whole, cubes(1, 1), 0), cubes(1, 1));
}

/// A block of n × n × 1 hexahedra, each 1 × 1 × `length`.
PartMesh<3> columns(int n, double length) {
  return support::structured_mesh<3>(
      {n, n, 1}, 1, [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return {n * x[0], n * x[1], length * x[2]};
      });
}

// From the corner cell of 9 × 9; a second layer reaches twice as far.
TEST(SubMesh, SurroundingsOfSlenderCellsReachHalfTheirLength) {
  EXPECT_EQ(surroundings(columns(9, 1.0), {0}, 1).size(), 4U);
  EXPECT_EQ(surroundings(columns(9, 1.0), {0}, 2).size(), 9U);
  // Vertices closer than 2.45 to the cell: at 1 + 2 in a row, not 1 + 2 aslant.
  const auto mesh = columns(9, 4.9);
  const auto near = surroundings(mesh, {0}, 1);
  EXPECT_TRUE(std::ranges::binary_search(near, 3));   // x from 3: 2 from 1
  EXPECT_FALSE(std::ranges::binary_search(near, 4));  // 3 away
  const auto wide = surroundings(mesh, {0}, 2);
  EXPECT_TRUE(std::ranges::includes(wide, near));
  EXPECT_TRUE(std::ranges::binary_search(wide, 5));
  EXPECT_FALSE(std::ranges::binary_search(wide, 6));
}

}  // namespace
}  // namespace clevis::mesh
