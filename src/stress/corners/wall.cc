#include "stress/corners/wall.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mesh/cells/topology.h"

namespace clevis::stress {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Ray from the origin against the segment a–b; a large value if it misses.
double hit(const Vector2d& direction, const Vector2d& a, const Vector2d& b,
           double miss) {
  Eigen::Matrix2d matrix;
  matrix << direction, a - b;
  if (std::abs(matrix.determinant()) < 1e-12 * (a - b).norm()) return miss;
  const Vector2d solution = matrix.inverse() * a;
  const bool meets =
      solution[0] > 0.0 && solution[1] >= -1e-9 && solution[1] <= 1.0 + 1e-9;
  return meets ? solution[0] : miss;
}

/// The same against a triangle.
double hit(const Vector3d& direction, const std::array<Vector3d, 3>& triangle,
           double miss) {
  const auto& [a, b, c] = triangle;
  Eigen::Matrix3d matrix;
  matrix << direction, a - b, a - c;
  if (std::abs(matrix.determinant()) <
      1e-12 * (a - b).norm() * (a - c).norm()) {
    return miss;
  }
  const Vector3d s = matrix.inverse() * a;
  const bool meets =
      s[0] > 0.0 && s[1] >= -1e-9 && s[2] >= -1e-9 && s[1] + s[2] <= 1.0 + 1e-9;
  return meets ? s[0] : miss;
}

bool touches(const BoundaryCorner& corner, unsigned vertex) {
  return vertex == corner.vertices[0] || vertex == corner.vertices[1];
}

double wall_of(const mesh::PartMesh<2>& mesh, const BoundaryCorner& corner,
               double miss) {
  const Vector2d at = corner.at.head<2>();
  const Vector2d direction = corner.bisector().head<2>();
  double wall = miss;
  for (const auto& face : mesh.boundary) {
    const auto v = mesh::face_vertices(mesh, face.cell, face.face);
    const unsigned a = v[0], b = v[1];
    if (touches(corner, a) || touches(corner, b)) continue;
    wall = std::min(wall, hit(direction, mesh.vertices[a] - at,
                              mesh.vertices[b] - at, miss));
  }
  return wall;
}

double wall_of(const mesh::PartMesh<3>& mesh, const BoundaryCorner& corner,
               double miss) {
  const Vector3d direction = corner.bisector();
  double wall = miss;
  for (const auto& face : mesh.boundary) {
    const auto v = mesh::face_vertices(mesh, face.cell, face.face);
    if (std::ranges::any_of(v, [&](unsigned vertex) {
          return touches(corner, vertex);
        })) {
      continue;
    }
    const auto point = [&](std::size_t k) -> Vector3d {
      return mesh.vertices[v[k]] - corner.at;
    };
    wall = std::min(wall, hit(direction, {point(0), point(1), point(2)}, miss));
    if (v[3] == mesh::kNoVertex) continue;
    wall = std::min(wall, hit(direction, {point(1), point(2), point(3)}, miss));
  }
  return wall;
}

}  // namespace

template <int dim>
double wall_thickness_at(const mesh::PartMesh<dim>& mesh,
                         const BoundaryCorner& corner) {
  Eigen::AlignedBox<double, dim> box;
  for (const auto& vertex : mesh.vertices) box.extend(vertex);
  return wall_of(mesh, corner, box.diagonal().norm());
}

template double wall_thickness_at<2>(const mesh::PartMesh<2>&,
                                     const BoundaryCorner&);
template double wall_thickness_at<3>(const mesh::PartMesh<3>&,
                                     const BoundaryCorner&);

}  // namespace clevis::stress
