#include "mesh/derived/split_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/basis/tensor_basis.h"
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

/// Farthest that points of a group's faces are from its cylinder, between the
/// mesh's own points too, over the radius [1].
double off_cylinder(const PartMesh<3>& mesh, int group) {
  constexpr int kPoints = 12;
  const auto& cylinder = *mesh.groups[std::size_t(group)].cylinder;
  const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(kPoints, 0.0, 1.0);
  const Eigen::MatrixXd along =
      lagrange(gauss_lobatto(mesh.degree), places).value;
  double farthest = 0.0;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const Eigen::MatrixXd end = along.row(face.face % 2 == 0 ? 0 : kPoints - 1);
    std::array<const Eigen::MatrixXd*, 3> basis = {&along, &along, &along};
    basis[std::size_t(face.face / 2)] = &end;
    const Eigen::Matrix3Xd points =
        interpolate<3>(mesh.cell_points[std::size_t(face.cell)], basis);
    for (const auto& point : points.colwise()) {
      const Eigen::Vector3d arm = point - cylinder.p_LC;
      const double radius =
          (arm - arm.dot(cylinder.axis_L) * cylinder.axis_L).norm();
      farthest = std::max(farthest, std::abs(radius / cylinder.radius - 1.0));
    }
  }
  return farthest;
}

TEST(RefinedMesh, BoresStayRoundWithADegreeLess) {
  // Degree 4 has 2.3 times the error of 5 over the same angle, over half of it
  // a thirty-second.
  constexpr double kMore = 2.0 * 2.3 / 32.0;
  const auto whole = read("ring.msh");
  int cylinders = 0;
  for (int g = 0; g < int(whole.groups.size()); ++g) {
    if (!whole.groups[std::size_t(g)].cylinder) continue;
    ++cylinders;
    const double before = off_cylinder(whole, g);
    EXPECT_GT(before, 1e-12);  // else this shows nothing
    for (const int n : {2, 3}) {
      const auto pieces = refined(whole, n);
      EXPECT_LE(pieces.degree, kPieceDegree);
      EXPECT_LE(off_cylinder(pieces, g), (1.0 + kMore) * before) << n;
    }
  }
  EXPECT_GT(cylinders, 0);
}

TEST(RefinedMesh, IsTheWholeWithSmallerCells) {
  const auto whole = read("ring.msh");
  const auto pieces = refined(whole, 2);
  EXPECT_EQ(pieces.cells.size(), 8 * whole.cells.size());
  const auto a = mass_properties(whole, 1.0), b = mass_properties(pieces, 1.0);
  EXPECT_NEAR(b.mass, a.mass, 1e-8 * a.mass);
  EXPECT_NO_THROW(check_connected(pieces, "ring"));
  EXPECT_NO_THROW(check_jacobians(pieces, "ring"));
  EXPECT_EQ(refined(whole, 1).degree, whole.degree);
}

TEST(SplitCells, PlateStaysAPlate) {
  const auto whole = read("plate_with_bore_41.msh");
  const auto plate = plate_mid_plane(split_cells(whole, 2));
  ASSERT_TRUE(plate.has_value());
  EXPECT_EQ(plate->cells.size(), 4 * plate_mid_plane(whole)->cells.size());
}

}  // namespace
}  // namespace clevis::mesh
