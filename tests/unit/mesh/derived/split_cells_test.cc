#include "mesh/derived/split_cells.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/cells/topology.h"
#include "mesh/derived/plate.h"
#include "mesh/quality/mass_properties.h"
#include "mesh/quality/mesh_validation.h"
#include "mesh/reading/mesh_reader.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

TEST(SplitCells, BoxOfTwoCellsHasTheVerticesOfItsLattice) {
  for (const int n : {1, 2, 3}) {
    const auto mesh = split_cells(read("box_order_1.msh"), n);
    EXPECT_EQ(mesh.cells.size(), std::size_t(2 * n * n * n));
    EXPECT_EQ(mesh.vertices.size(),
              std::size_t((2 * n + 1) * (n + 1) * (n + 1)));
    EXPECT_EQ(mesh.boundary.size(), std::size_t(10 * n * n));
  }
}

TEST(SplitCells, VerticesStandAtTheCornersOfTheirCells) {
  const auto mesh = split_cells(read("ring.msh"), 2);
  const int row = mesh.degree + 1;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (int v = 0; v < 8; ++v) {
      const int at =
          mesh.degree * ((v & 1) + row * (((v >> 1) & 1) + row * (v >> 2)));
      const auto& vertex = mesh.vertices[mesh.cells[c][std::size_t(v)]];
      EXPECT_LT((vertex - mesh.cell_points[c].col(at)).norm(), 1e-15);
    }
  }
}

TEST(SplitCells, GeometryAndGroupsAreThoseOfTheWhole) {
  const auto whole = read("ring.msh");
  const auto pieces = split_cells(whole, 3);
  const auto a = mass_properties(whole, 1.0), b = mass_properties(pieces, 1.0);
  EXPECT_NEAR(b.mass, a.mass, 1e-13 * a.mass);
  EXPECT_LT((b.inertia_LCm - a.inertia_LCm).norm(),
            1e-12 * a.inertia_LCm.norm());
  ASSERT_EQ(pieces.groups.size(), whole.groups.size());
  for (int g = 0; g < int(whole.groups.size()); ++g) {
    const auto of_whole = face_properties(whole, g);
    const auto of_pieces = face_properties(pieces, g);
    EXPECT_NEAR(of_pieces.area, of_whole.area, 1e-12 * of_whole.area);
    EXPECT_LT((of_pieces.centroid - of_whole.centroid).norm(), 1e-14);
  }
  EXPECT_NO_THROW(check_connected(pieces, "ring"));
  EXPECT_NO_THROW(check_jacobians(pieces, "ring"));
}

TEST(SplitCells, PlateStaysAPlate) {
  const auto whole = read("plate_with_bore_41.msh");
  const auto plate = plate_mid_plane(split_cells(whole, 2));
  ASSERT_TRUE(plate.has_value());
  EXPECT_EQ(plate->cells.size(), 4 * plate_mid_plane(whole)->cells.size());
}

}  // namespace
}  // namespace clevis::mesh
