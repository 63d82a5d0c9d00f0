#include "beam/sections/part_model.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mesh/basis/simplex_basis.h"

namespace clevis::beam {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Points = Eigen::Matrix3Xd;
using Triangle = std::array<Vector3d, 3>;

namespace {

// Volume by the Jacobian in the middle: exact for parallelepipeds.
void add_box_lumps(const Points& points, int degree, std::vector<Lump>& lumps) {
  const int n = degree + 1;
  const auto at = [&](int i, int j, int k) -> Vector3d {
    return points.col(i + n * (j + n * k));
  };
  for (int k = 0; k < degree; ++k) {
    for (int j = 0; j < degree; ++j) {
      for (int i = 0; i < degree; ++i) {
        Matrix3d edges = Matrix3d::Zero();
        Vector3d middle = Vector3d::Zero();
        for (int corner = 0; corner < 8; ++corner) {
          const int a = corner & 1, b = (corner >> 1) & 1, c = corner >> 2;
          const Vector3d p = at(i + a, j + b, k + c);
          middle += 0.125 * p;
          edges.col(0) += (a == 1 ? 0.25 : -0.25) * p;
          edges.col(1) += (b == 1 ? 0.25 : -0.25) * p;
          edges.col(2) += (c == 1 ? 0.25 : -0.25) * p;
        }
        lumps.push_back({std::abs(edges.determinant()), middle});
      }
    }
  }
}

void add_tetrahedron_lumps(const Points& points,
                           const std::vector<std::array<int, 4>>& parts,
                           std::vector<Lump>& lumps) {
  for (const auto& part : parts) {
    Matrix3d edges;
    for (std::size_t d = 0; d < 3; ++d) {
      edges.col(static_cast<Index>(d)) =
          points.col(part[d + 1]) - points.col(part[0]);
    }
    lumps.push_back({std::abs(edges.determinant()) / 6.0,
                     points(Eigen::all, part).rowwise().mean()});
  }
}

void add_quad_triangles(const Points& points, int degree, int face,
                        std::vector<Triangle>& triangles) {
  const int n = degree + 1;
  const std::array<int, 3> stride{1, n, n * n};
  const auto normal = static_cast<std::size_t>(face / 2);
  const int u = stride[(normal + 1) % 3], v = stride[(normal + 2) % 3];
  const int start = (face % 2) * degree * stride[normal];
  for (int j = 0; j < degree; ++j) {
    for (int i = 0; i < degree; ++i) {
      const int at = start + i * u + j * v;
      const Vector3d a = points.col(at), b = points.col(at + u),
                     c = points.col(at + u + v), d = points.col(at + v);
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
}

std::vector<Triangle> surface(const mesh::PartMesh<3>& mesh) {
  std::vector<Triangle> triangles;
  for (const mesh::BoundaryFace& face : mesh.boundary) {
    const Points& points =
        mesh.cell_points[static_cast<std::size_t>(face.cell)];
    if (mesh.shape == mesh::CellShape::kTensor) {
      add_quad_triangles(points, mesh.degree, face.face, triangles);
      continue;
    }
    const auto on_face = mesh::simplex_face_lattice<3>(mesh.degree, face.face);
    const auto corner = [&](int i) -> Vector3d {
      return points.col(on_face[static_cast<std::size_t>(i)]);
    };
    for (const auto& [a, b, c] : mesh::simplex_parts<2>(mesh.degree)) {
      triangles.push_back({corner(a), corner(b), corner(c)});
    }
  }
  return triangles;
}

// Where a plane meets a triangle; a corner on the plane counts as above, so
// that neighbours agree.
Outline cut_triangles(const std::vector<Triangle>& triangles,
                      const Vector3d& point, const Vector3d& normal) {
  Outline outline;
  for (const Triangle& triangle : triangles) {
    std::array<double, 3> height{};
    for (std::size_t i = 0; i < 3; ++i) {
      height[i] = (triangle[i] - point).dot(normal);
    }
    std::array<Vector3d, 2> ends;
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3 && found < 2; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((height[i] >= 0.0) == (height[j] >= 0.0)) continue;
      const double t = height[i] / (height[i] - height[j]);
      ends[found++] = triangle[i] + t * (triangle[j] - triangle[i]);
    }
    if (found == 2) outline.push_back(ends);
  }
  return outline;
}

}  // namespace

PartModel part_model(const mesh::PartMesh<3>& mesh) {
  PartModel model;
  const auto parts = mesh::simplex_parts<3>(mesh.degree);
  for (const Points& points : mesh.cell_points) {
    if (mesh.shape == mesh::CellShape::kTensor) {
      add_box_lumps(points, mesh.degree, model.lumps);
    } else {
      add_tetrahedron_lumps(points, parts, model.lumps);
    }
  }
  // Made with the first section: a model that is asked for none needs no
  // neighbours of cells.
  model.section = [&mesh, cutter = std::optional<mesh::SectionCutter>()](
                      const Vector3d& point, const Vector3d& normal) mutable {
    if (!cutter) cutter.emplace(mesh);
    return cutter->at(point, normal);
  };
  model.outline = [triangles = surface(mesh)](const Vector3d& point,
                                              const Vector3d& normal) {
    return cut_triangles(triangles, point, normal);
  };
  return model;
}

}  // namespace clevis::beam
