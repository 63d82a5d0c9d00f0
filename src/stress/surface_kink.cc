#include "stress/surface_kink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/discretization.h"
#include "elasticity/tabulation.h"
#include "mesh/simplex_basis.h"

namespace clevis::stress {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Edge = std::pair<unsigned, unsigned>;  // lower vertex first

constexpr int kSamples = 5;

/// Edges of a face by the cell's local vertices.
std::vector<std::array<unsigned, 2>> face_edges(mesh::CellShape shape,
                                                int face) {
  std::vector<std::array<unsigned, 2>> edges;
  if (shape == mesh::CellShape::kSimplex) {
    const auto& v = mesh::simplex_face<3>(face);
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back(
          {static_cast<unsigned>(v[k]), static_cast<unsigned>(v[(k + 1) % 3])});
    }
    return edges;
  }
  const auto axis = static_cast<unsigned>(face / 2);
  for (unsigned v = 0; v < 8; ++v) {
    if (((v >> axis) & 1U) != static_cast<unsigned>(face % 2)) continue;
    for (unsigned d = 0; d < 3; ++d) {
      if (d != axis && ((v >> d) & 1U) == 0) edges.push_back({v, v | 1U << d});
    }
  }
  return edges;
}

Vector3d reference_vertex(mesh::CellShape shape, unsigned v) {
  if (shape == mesh::CellShape::kSimplex) {
    return v == 0 ? Vector3d::Zero().eval() : Vector3d::Unit(v - 1).eval();
  }
  return {double(v & 1U), double((v >> 1) & 1U), double((v >> 2) & 1U)};
}

/// Outward unit normals of a face at points between two of its cell's vertices.
Matrix3Xd normals(const mesh::PartMesh<3>& mesh, const mesh::BoundaryFace& face,
                  unsigned from, unsigned to) {
  elasticity::ReferencePoints<3> points(3, kSamples);
  const Vector3d a = reference_vertex(mesh.shape, from);
  const Vector3d b = reference_vertex(mesh.shape, to);
  for (int k = 0; k < kSamples; ++k) {
    points.col(k) = a + (b - a) * k / (kSamples - 1.0);
  }
  const auto geometry = elasticity::cell_geometry<3>(
      mesh.cell_points[static_cast<std::size_t>(face.cell)],
      elasticity::tabulate_geometry<3>(mesh.shape, mesh.degree, points));
  const Vector3d outward =
      elasticity::face_gauss<3>(mesh.shape, face.face, 1).outward;
  Matrix3Xd result(3, kSamples);
  for (int k = 0; k < kSamples; ++k) {
    result.col(k) =
        (geometry.inverse_jacobian[static_cast<std::size_t>(k)].transpose() *
         outward)
            .normalized();
  }
  return result;
}

/// Largest angle between normals; 0 if they belong to an edge of the part.
double kink(const Matrix3Xd& one, const Matrix3Xd& other) {
  constexpr double kSmooth = 20.0 * std::numbers::pi / 180.0;
  double largest = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const Vector3d a = one.col(k);
    const Vector3d b = other.col(k);
    largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return largest < kSmooth ? largest : 0.0;
}

}  // namespace

double largest_kink(const mesh::PartMesh<3>& mesh,
                    const std::vector<int>& cells) {
  std::vector<char> is_near(mesh.vertices.size(), 0);
  for (const int cell : cells) {
    for (const unsigned v : mesh.cells[static_cast<std::size_t>(cell)]) {
      is_near[v] = 1;
    }
  }
  std::map<Edge, Matrix3Xd> first;
  double largest = 0.0;
  for (const auto& face : mesh.boundary) {
    const auto& ids = mesh.cells[static_cast<std::size_t>(face.cell)];
    for (auto [from, to] : face_edges(mesh.shape, face.face)) {
      if (is_near[ids[from]] == 0 || is_near[ids[to]] == 0) continue;
      if (ids[from] > ids[to]) std::swap(from, to);
      const auto here = normals(mesh, face, from, to);
      const auto at = first.try_emplace(Edge{ids[from], ids[to]}, here);
      if (!at.second) largest = std::max(largest, kink(at.first->second, here));
    }
  }
  return largest;
}

}  // namespace clevis::stress
