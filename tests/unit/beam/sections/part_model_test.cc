#include "beam/sections/part_model.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "mesh/reading/mesh_reader.h"
#include "support/source_dir.h"

namespace clevis::beam {
namespace {

using Eigen::Vector3d;

// A box 40 × 20 × 5 mm of one sheared hexahedron whose lattice has `degree`.
mesh::PartMesh<3> box(int degree) {
  mesh::PartMesh<3> mesh;
  mesh.degree = degree;
  const int n = degree + 1;
  Eigen::Matrix3Xd points(3, n * n * n);
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double y = 0.02 * j / degree;
        points.col(i + n * (j + n * k)) =
            Vector3d(0.04 * i / degree + 0.5 * y, y, 0.005 * k / degree);
      }
    }
  }
  mesh.cell_points = {points};
  mesh.cells.resize(1);
  for (int face = 0; face < 6; ++face) mesh.boundary.push_back({0, face, -1});
  return mesh;
}

double outline_length(const Outline& outline) {
  double length = 0.0;
  for (const auto& [a, b] : outline) length += (b - a).norm();
  return length;
}

TEST(PartModel, LumpsHoldTheVolumeAndItsCentre) {
  for (const int degree : {1, 2, 4}) {
    const mesh::PartMesh<3> mesh = box(degree);
    double volume = 0.0;
    Vector3d first = Vector3d::Zero();
    for (const Lump& lump : part_model(mesh).lumps) {
      volume += lump.volume;
      first += lump.volume * lump.p_LQ;
    }
    EXPECT_NEAR(volume, 4e-6, 1e-18);
    EXPECT_LT((first / volume - Vector3d(0.025, 0.01, 0.0025)).norm(), 1e-15);
  }
}

TEST(PartModel, OutlineGoesOnceRound) {
  for (const int degree : {1, 2, 3}) {
    const mesh::PartMesh<3> mesh = box(degree);
    const PartModel model = part_model(mesh);
    const Outline middle = model.outline({0.0, 0.0, 0.0025}, Vector3d::UnitZ());
    const double sheared = std::hypot(0.02, 0.01);
    EXPECT_NEAR(outline_length(middle), 2.0 * (0.04 + sheared), 1e-12);
    const Outline across = model.outline({0.025, 0.0, 0.0}, Vector3d::UnitX());
    EXPECT_NEAR(outline_length(across), 2.0 * (0.02 + 0.005), 1e-12);
    EXPECT_TRUE(model.outline({0.0, 0.0, 0.006}, Vector3d::UnitZ()).empty());
  }
}

TEST(PartModel, TetrahedronIsOneLumpWithFourFaces) {
  mesh::PartMesh<3> mesh;
  mesh.shape = mesh::CellShape::kSimplex;
  Eigen::Matrix3Xd points(3, 4);
  points << 0.0, 0.01, 0.0, 0.0,  //
      0.0, 0.0, 0.02, 0.0,        //
      0.0, 0.0, 0.0, 0.03;
  mesh.cell_points = {points};
  for (int face = 0; face < 4; ++face) mesh.boundary.push_back({0, face, -1});
  const PartModel model = part_model(mesh);
  ASSERT_EQ(model.lumps.size(), 1u);
  EXPECT_NEAR(model.lumps[0].volume, 1e-6, 1e-20);
  EXPECT_LT((model.lumps[0].p_LQ - Vector3d(0.0025, 0.005, 0.0075)).norm(),
            1e-15);
  // At half height the section is a triangle of half the size.
  const Outline half = model.outline({0.0, 0.0, 0.015}, Vector3d::UnitZ());
  EXPECT_NEAR(outline_length(half), 0.005 + 0.01 + std::hypot(0.005, 0.01),
              1e-12);
}

TEST(PartModel, CurvedTetrahedraAreTheirParts) {
  const auto file =
      support::source_dir() / "tests/data/meshes/ring_tetrahedra_order_2.msh";
  const mesh::PartMesh<3> ring = mesh::read_part_mesh(file, 1e-3);
  const PartModel model = part_model(ring);
  const double pi = std::acos(-1.0);
  double volume = 0.0;
  for (const Lump& lump : model.lumps) volume += lump.volume;
  EXPECT_NEAR(volume, pi * 300e-6 * 6e-3, 3e-3 * volume);
  const Outline middle = model.outline({0.0, 0.0, 5e-3}, Vector3d::UnitZ());
  const double circles = 2.0 * pi * 30e-3;
  EXPECT_NEAR(outline_length(middle), circles, 2e-3 * circles);
}

}  // namespace
}  // namespace clevis::beam
