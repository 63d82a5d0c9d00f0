#include "mesh/derived/plate.h"

#include <cmath>
#include <map>
#include <set>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "mesh/basis/tensor_basis.h"
#include "mesh/gmsh/gmsh_file.h"
#include "mesh/gmsh/gmsh_reader.h"
#include "mesh/quality/mass_properties.h"
#include "mesh/reading/cells.h"
#include "mesh/rounds/cylinder_groups.h"
#include "mesh/rounds/exact_geometry.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

PartMesh<2> plane_of(const PartMesh<3>& mesh) {
  auto plane = plate_mid_plane(mesh);
  EXPECT_TRUE(plane.has_value());
  return plane.value_or(PartMesh<2>{});
}

TEST(Plate, MidPlaneHasTheMassAndInertiaOfThePart) {
  for (const char* name : {"plate_with_bore_22.msh", "ring.msh"}) {
    const PartMesh<3> mesh = read(name);
    const PartMesh<2> plane = plane_of(mesh);
    const auto solid = mass_properties(mesh, 7850.0);
    const auto flat = mass_properties(plane, 7850.0);
    EXPECT_NEAR(flat.mass, solid.mass, 1e-12 * solid.mass) << name;
    EXPECT_LT((flat.p_LCm - solid.p_LCm).norm(), 1e-15);
    EXPECT_LT((flat.inertia_LCm - solid.inertia_LCm).norm(),
              1e-12 * solid.inertia_LCm.norm());
  }
}

TEST(Plate, CarriesThicknessDegreeAndSideGroups) {
  const PartMesh<3> mesh = read("plate_with_bore_41.msh");
  const PartMesh<2> plane = plane_of(mesh);
  EXPECT_EQ(plane.cells.size(), 32u);
  EXPECT_EQ(plane.vertices.size(), 48u);
  EXPECT_EQ(plane.degree, mesh.degree);
  EXPECT_NEAR(plane.thickness, 4e-3, 1e-17);
  EXPECT_NEAR(plane.mid_plane_z, 2e-3, 1e-17);
  // "top" has no place in the plane: a load on it must not get lost there.
  ASSERT_EQ(plane.groups.size(), 3u);
  EXPECT_EQ(plane.groups[0].name, "bore_A");
  EXPECT_EQ(plane.groups[1].name, "right");
  EXPECT_EQ(plane.groups[2].name, "left");
  ASSERT_TRUE(plane.groups[0].cylinder);
  EXPECT_NEAR(plane.groups[0].cylinder->radius, 5e-3, 1e-15);
}

TEST(Plate, EdgesOfGroupsLieWhereTheGroupsAre) {
  const PartMesh<2> plane = plane_of(read("plate_with_bore_41.msh"));
  const auto nodes = gauss_lobatto(plane.degree);
  const int n = plane.degree + 1;
  std::map<int, int> edges;
  for (const BoundaryFace& edge : plane.boundary) {
    ++edges[edge.group];
    const auto& points = plane.cell_points[std::size_t(edge.cell)];
    for (int q = 0; q < n * n; ++q) {
      const int along = edge.face / 2 == 0 ? q % n : q / n;
      if (along != (edge.face % 2) * plane.degree) continue;
      const Eigen::Vector2d p = points.col(q);
      const double off = edge.group == 0   ? p.norm() - 5e-3
                         : edge.group == 1 ? p.x() - 20e-3
                         : edge.group == 2 ? p.x() + 20e-3
                                           : std::abs(p.y()) - 20e-3;
      EXPECT_NEAR(off, 0.0, 1e-16) << edge.group;
    }
  }
  EXPECT_EQ(edges, (std::map<int, int>{{-1, 8}, {0, 16}, {1, 4}, {2, 4}}));
}

TEST(Plate, QuadsArePositiveAndKeepTheirCorners) {
  const PartMesh<2> plane = plane_of(read("plate_with_bore_41.msh"));
  const int n = plane.degree + 1;
  const std::array<int, 4> corners = {0, n - 1, n * (n - 1), n * n - 1};
  const auto nodes = gauss_lobatto(plane.degree);
  const LagrangeBasis basis = lagrange(nodes, nodes);
  for (std::size_t c = 0; c < plane.cells.size(); ++c) {
    for (std::size_t v = 0; v < 4; ++v) {
      EXPECT_LT((plane.cell_points[c].col(corners[v]) -
                 plane.vertices[plane.cells[c][v]])
                    .norm(),
                1e-17);
    }
    const auto grid = map_grid<2>(plane.cell_points[c], {&basis, &basis});
    for (int q = 0; q < n * n; ++q) {
      EXPECT_GT(grid.jacobian(q).determinant(), 0.0);
    }
  }
}

TEST(Plate, HigherOrderFilesAreRecognised) {
  EXPECT_TRUE(plate_mid_plane(read("ring_order_2.msh")));
  EXPECT_TRUE(plate_mid_plane(read("ring_order_3.msh")));
  EXPECT_TRUE(plate_mid_plane(read("box_order_4.msh")));
}

/// The plate with its nodes moved by `move` (in mm).
template <class Move>
PartMesh<3> moved(Move move) {
  GmshFile file = read_gmsh_file(data("plate_with_bore_41.msh"));
  for (auto& p : file.points) move(p);
  PartMesh<3> mesh = build_cells(file, 1e-3);
  fit_cylinder_groups(mesh, "moved");
  put_on_cylinders(mesh);
  return mesh;
}

TEST(Plate, OnlyAPlateAlongZOfOneThicknessHasAMidPlane) {
  EXPECT_TRUE(plate_mid_plane(moved([](auto& p) {
    p.z() += 7.0;
  })));
  // Tapered by 1 µm at one end.
  EXPECT_FALSE(plate_mid_plane(moved([](auto& p) {
    p.z() *= 1.0 + 1e-3 / 80.0 * p.x() / 20.0;
  })));
  // On edge.
  EXPECT_FALSE(plate_mid_plane(moved([](auto& p) {
    p = Eigen::Vector3d(p.y(), p.z(), p.x());
  })));
  // Sheared, so that its normal edges lean.
  EXPECT_FALSE(plate_mid_plane(moved([](auto& p) {
    if (p.norm() > 15.0) p.x() += 1e-4 * p.z();
  })));
}

TEST(Plate, OfTetrahedraIsTheTrianglesAtItsBottom) {
  const PartMesh<3> solid = read("ring_tetrahedra.msh");
  const auto flat = plate_mid_plane(solid);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->shape, CellShape::kSimplex);
  EXPECT_NEAR(flat->thickness, 6e-3, 1e-14);
  EXPECT_NEAR(flat->mid_plane_z, 5e-3, 1e-14);
  ASSERT_EQ(flat->groups.size(), 2u);  // the ends are lids
  const double mass = mass_properties(solid, 1.0).mass;
  EXPECT_NEAR(mass_properties(*flat, 1.0).mass, mass, 1e-7 * mass);
  // A lid on which the normal leans, and a wall that does.
  for (const double lean : {1e-4, -1e-4}) {
    GmshFile file = read_gmsh_file(data("ring_tetrahedra.msh"));
    for (auto& p : file.points) {
      if (lean > 0.0 && p.z() > 7.9) p.z() += lean * p.x();
      if (lean < 0.0) p.x() += lean * p.z();
    }
    PartMesh<3> mesh = build_cells(file, 1e-3);
    EXPECT_FALSE(plate_mid_plane(mesh)) << lean;
  }
}

TEST(Plate, AGroupOnOneLayerOnlyStaysInThreeDimensions) {
  PartMesh<3> mesh = read("plate_with_bore_41.msh");
  const int right = group_index(mesh, "right");
  int changed = 0;
  for (BoundaryFace& face : mesh.boundary) {
    if (face.group == right && changed < 1) {
      face.group = -1;
      ++changed;
    }
  }
  EXPECT_FALSE(plate_mid_plane(mesh));
}

}  // namespace
}  // namespace clevis::mesh
