// Curved second-order meshes as gmsh 4.8.4 writes them, without any group
// that is put on a cylinder: the file's own nodes alone carry the shape.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mesh/cells/section.h"
#include "mesh/gmsh/gmsh_reader.h"
#include "mesh/quality/mass_properties.h"
#include "mesh/quality/mesh_validation.h"
#include "mesh/reading/cells.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

/// The mesh as the file has it, no group on a cylinder.
PartMesh<3> as_in_file(const std::string& name) {
  const PartMesh<3> mesh = build_cells(read_gmsh_file(data(name)), 1e-3);
  check_jacobians(mesh, name);
  return mesh;
}

TEST(CurvedFiles, TenNodeTetrahedraOfABall) {
  const PartMesh<3> mesh = as_in_file("sphere.msh");
  ASSERT_EQ(mesh.degree, 2);
  ASSERT_EQ(mesh.cell_points[0].cols(), 10);
  const double r = 10e-3, volume = kPi / 6.0 * r * r * r;
  const double got = mass_properties(mesh, 1.0).mass;
  PartMesh<3> straight = mesh;
  straight.degree = 1;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (auto& points = straight.cell_points[c];
         const unsigned v : mesh.cells[c]) {
      if (v == mesh.cells[c][0]) points.resize(3, 0);
      points.conservativeResize(3, points.cols() + 1);
      points.rightCols<1>() = mesh.vertices[v];
    }
  }
  const double faceted = mass_properties(straight, 1.0).mass;
  EXPECT_LT(std::abs(faceted / volume - 1.0), 0.1);
  EXPECT_GT(std::abs(faceted / volume - 1.0), 0.02);
  EXPECT_LT(std::abs(got / volume - 1.0), 5e-4);
  EXPECT_LT(50.0 * std::abs(got - volume), std::abs(faceted - volume));
  const auto surface = face_properties(mesh, group_index(mesh, "all"));
  const double area = (kPi / 2.0 + 3.0 * kPi / 4.0) * r * r;
  EXPECT_NEAR(surface.area, area, 5e-4 * area);
  EXPECT_LT(surface.area_vector.norm(), 1e-12 * area);  // closed
  const Section cut_across = cut(mesh, {0.0, 0.0, 4e-3}, Vector3d::UnitZ());
  const double disc = kPi / 4.0 * (100.0 - 16.0) * 1e-6;
  EXPECT_NEAR(cut_across.area, disc, 4e-3 * disc);
}

TEST(CurvedFiles, TheLastTwoMiddleNodesStandInGmshsOrder) {
  GmshFile vtk = read_gmsh_file(data("sphere.msh"));
  for (const GmshElement& element : vtk.elements) {
    if (element.type->dim != 3) continue;
    std::swap(vtk.element_nodes[element.first_node + 8],
              vtk.element_nodes[element.first_node + 9]);
  }
  EXPECT_THROW(check_jacobians(build_cells(vtk, 1e-3), "VTK's order"), Error);
}

TEST(CurvedFiles, TwentyAndTwentySevenNodeHexahedraOfARing) {
  const double volume = kPi * 300e-6 * 6e-3;
  for (const char* name : {"ring_serendipity.msh", "ring_order_2.msh",
                           "ring_tetrahedra_order_2.msh"}) {
    SCOPED_TRACE(name);
    const PartMesh<3> mesh = as_in_file(name);
    EXPECT_EQ(mesh.degree, 2);
    // Facets of 22.5°: a straight one lacks 2.6 %, an arc of degree 2 3e-5.
    EXPECT_NEAR(mass_properties(mesh, 1.0).mass, volume, 5e-5 * volume);
    const auto bore = face_properties(mesh, group_index(mesh, "bore_A"));
    const double wall = 2.0 * kPi * 10e-3 * 6e-3;
    EXPECT_NEAR(bore.area, wall, 1e-4 * wall);
  }
}

TEST(CurvedFiles, WithoutItsCurvatureAMeshIsFaceted) {
  const double volume = kPi * 300e-6 * 6e-3;
  const double got = mass_properties(as_in_file("ring.msh"), 1.0).mass;
  EXPECT_GT(std::abs(got / volume - 1.0), 0.02);
}

}  // namespace
}  // namespace clevis::mesh
