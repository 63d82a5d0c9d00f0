#include "mesh/derived/quadrangles.h"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "mesh/basis/tensor_basis.h"
#include "support/simplex_mesh.h"

namespace clevis::mesh {
namespace {

using Eigen::Vector2d;

/// A quarter of a ring of 1 and 2 m, its triangles' sides all curved.
PartMesh<2> ring(int degree) {
  return support::simplex_mesh<2>(
      {3, 4}, degree, [](const Vector2d& x) -> Vector2d {
        const double radius = 1.0 + x[0];
        const double angle = 0.5 * M_PI * x[1];
        return {radius * std::cos(angle), radius * std::sin(angle)};
      });
}

/// Area by Gauss points of every cell; all Jacobians must be positive.
double area(const PartMesh<2>& mesh) {
  const auto rule = gauss(mesh.degree + 2);
  const auto basis = lagrange(gauss_lobatto(mesh.degree), rule.points);
  double sum = 0.0;
  for (const auto& points : mesh.cell_points) {
    const auto grid = map_grid<2>(points, {&basis, &basis});
    for (Eigen::Index j = 0; j < rule.weights.size(); ++j) {
      for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
        const double determinant =
            grid.jacobian(i + j * rule.weights.size()).determinant();
        EXPECT_GT(determinant, 0.0);
        sum += rule.weights[i] * rule.weights[j] * determinant;
      }
    }
  }
  return sum;
}

TEST(Quadrangles, HaveTheArea) {
  for (const int degree : {2, 3, 4}) {
    const auto quadrangles = quadrangles_of(ring(degree));
    EXPECT_EQ(quadrangles.cells.size(), 3 * ring(degree).cells.size());
    EXPECT_NEAR(area(quadrangles), 0.75 * M_PI, degree == 2 ? 2e-4 : 2e-5);
  }
}

TEST(Quadrangles, NeighboursHoldTheSamePointsOnTheirSide) {
  const auto mesh = quadrangles_of(ring(3));
  const Eigen::Index n = mesh.degree + 1;
  std::map<std::pair<unsigned, unsigned>, Vector2d> first_points;
  int shared = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& v = mesh.cells[c];
    const std::array<std::array<std::size_t, 2>, 4> ends = {
        {{0, 2}, {1, 3}, {0, 1}, {2, 3}}};
    for (std::size_t side = 0; side < 4; ++side) {
      const unsigned a = v[ends[side][0]];
      const unsigned b = v[ends[side][1]];
      const Eigen::Index k = a < b ? 1 : n - 2;  // next to the lower vertex
      const Eigen::Index at = side == 0   ? k * n
                              : side == 1 ? k * n + n - 1
                              : side == 2 ? k
                                          : k + n * (n - 1);
      const Vector2d point = mesh.cell_points[c].col(at);
      const auto [entry, is_new] =
          first_points.emplace(std::minmax(a, b), point);
      if (is_new) continue;
      ++shared;
      EXPECT_LT((entry->second - point).norm(), 1e-14);
    }
  }
  EXPECT_GT(shared, 50);
}

TEST(Quadrangles, GroupsStayOnTheirSides) {
  const auto triangles = ring(2);
  const auto mesh = quadrangles_of(triangles);
  EXPECT_EQ(mesh.boundary.size(), 2 * triangles.boundary.size());
  const Eigen::Index n = mesh.degree + 1;
  for (const BoundaryFace& face : mesh.boundary) {
    const auto& name = mesh.groups[static_cast<std::size_t>(face.group)].name;
    const auto& points = mesh.cell_points[static_cast<std::size_t>(face.cell)];
    for (Eigen::Index k = 0; k < n; ++k) {
      const Vector2d x = points.col(face.face == 2 ? k : k * n);
      if (name == "x0") EXPECT_NEAR(x.norm(), 1.0, 3e-3);
      if (name == "x1") EXPECT_NEAR(x.norm(), 2.0, 3e-3);
      if (name == "y0") EXPECT_NEAR(x.y(), 0.0, 1e-14);
      if (name == "y1") EXPECT_NEAR(x.x(), 0.0, 1e-14);
    }
  }
}

}  // namespace
}  // namespace clevis::mesh
