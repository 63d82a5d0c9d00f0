// Re-entrant corners and clamped edges have no finite peak: the p-sequence
// must not call them converged; a fillet in their place has one. Anchors B8.

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "elasticity/displacement_basis.h"
#include "stress/peak_band.h"
#include "stress/stress_history.h"
#include "support/annulus_mesh.h"

namespace clevis {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using stress::Convergence;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};
constexpr double kSize = 0.02;
constexpr double kThickness = 0.005;
constexpr double kTolerance = 0.01;

/// Peak von Mises of degrees 2, 3, 4 under a traction on group "y1".
stress::Band band_of(const mesh::PartMesh<2>& mesh, double area,
                     const Vector3d& centre,
                     const std::map<std::string, std::array<bool, 3>>& fixed,
                     const Vector3d& traction) {
  loads::SurfaceLoad load;
  load.group = "y1";
  load.traction = traction;
  load.resultant.force = area * traction;
  load.resultant.moment = centre.cross(load.resultant.force);
  loads::LoadHistory history;
  history.instants.push_back({});
  history.instants[0].surface_loads.push_back(load);
  std::vector<stress::SequenceValue> sequence;
  for (int degree = 2; degree <= 4; ++degree) {
    const auto basis =
        elasticity::solve<2>({mesh, kSteel, history, fixed, "plate"}, degree);
    sequence.push_back(
        {degree, stress::stress_history<2>(basis, kSteel, 8).largest()});
  }
  const auto band = stress::peak_band(sequence, kTolerance);
  std::printf("peaks %.2f %.2f %.2f MPa, band %.2f to %.2f\n",
              sequence[0].value / 1e6, sequence[1].value / 1e6,
              sequence[2].value / 1e6, band.low / 1e6, band.high / 1e6);
  return band;
}

/// Square of 2 × 2 blocks without the block x > 1, y < 1: a 270° notch.
mesh::PartMesh<2> notched_plate(int per_block) {
  const int n = 2 * per_block;
  auto mesh =
      support::structured_mesh<2>({n, n}, 1, [](const Vector2d& x) -> Vector2d {
        return kSize * x;
      });
  mesh.thickness = kThickness;
  auto result = mesh;
  result.cells.clear();
  result.cell_points.clear();
  result.boundary.clear();
  std::vector<int> number(mesh.cells.size(), -1);
  for (int c = 0; c < n * n; ++c) {
    if (c % n >= per_block && c / n < per_block) continue;
    number[static_cast<std::size_t>(c)] = static_cast<int>(result.cells.size());
    result.cells.push_back(mesh.cells[static_cast<std::size_t>(c)]);
    result.cell_points.push_back(mesh.cell_points[static_cast<std::size_t>(c)]);
  }
  for (mesh::BoundaryFace face : mesh.boundary) {
    face.cell = number[static_cast<std::size_t>(face.cell)];
    if (face.cell >= 0) result.boundary.push_back(face);
  }
  // Vertices of the removed block go; the order of the others stays.
  std::vector<unsigned> to(mesh.vertices.size(), 0U);
  for (const auto& cell : result.cells) {
    for (unsigned vertex : cell) to[vertex] = 1U;
  }
  result.vertices.clear();
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == 0U) continue;
    to[v] = static_cast<unsigned>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[v]);
  }
  for (auto& cell : result.cells) {
    for (unsigned& vertex : cell) vertex = to[vertex];
  }
  return result;
}

TEST(Singular, ReentrantCornerIsNotConverged) {
  for (int per_block : {1, 2, 4}) {
    const auto band =
        band_of(notched_plate(per_block), kSize * kThickness,
                Vector3d(kSize / 2, kSize, 0.0), {{"y0", {true, true, false}}},
                Vector3d(30e6, 10e6, 0.0));
    EXPECT_NE(band.verdict, Convergence::kConverged) << per_block;
  }
}

// The loaded half of the notch's faces held instead: clamped against free.
TEST(Singular, ClampedEdgeIsNotConverged) {
  for (int cells : {2, 4, 8}) {
    auto mesh = support::structured_mesh<2>({cells, cells}, 1,
                                            [](const Vector2d& x) -> Vector2d {
                                              return kSize * x;
                                            });
    mesh.thickness = kThickness;
    const auto band =
        band_of(mesh, kSize * kThickness, Vector3d(kSize / 2, kSize, 0.0),
                {{"y0", {true, true, false}}}, Vector3d(0.0, 50e6, 0.0));
    EXPECT_NE(band.verdict, Convergence::kConverged) << cells;
  }
}

// Curved beam: a fillet has a finite peak that degree 4 reaches.
TEST(Singular, FilletConverges) {
  const support::Annulus fillet{.inner = 0.25 * kSize,
                                .outer = kSize,
                                .thickness = kThickness,
                                .radial = 4,
                                .angular = 6};
  const auto mesh = support::sector_mesh<2>(fillet);
  const double width = fillet.outer - fillet.inner;
  const auto band =
      band_of(mesh, width * kThickness,
              Vector3d(0.0, 0.5 * (fillet.outer + fillet.inner), 0.0),
              {{"y0", {false, true, false}}, {"x1", {true, false, false}}},
              Vector3d(-40e6, 0.0, 0.0));
  EXPECT_EQ(band.verdict, Convergence::kConverged);
}

}  // namespace
}  // namespace clevis
