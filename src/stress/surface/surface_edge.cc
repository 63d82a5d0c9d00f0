#include "stress/surface/surface_edge.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/fe_space/tabulation.h"
#include "mesh/basis/simplex_basis.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;
using Edge = std::pair<unsigned, unsigned>;  // lower vertex first

constexpr int kPoints = kEdgeIntervals + 1;

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

/// Sides of edges of one mesh; what they share by their place in a cell is
/// tabulated once.
class EdgeSides {
 public:
  explicit EdgeSides(const mesh::PartMesh<3>& mesh) : mesh_(mesh) {}

  /// @param face  number in PartMesh::boundary.
  EdgeSide side(int face, unsigned from, unsigned to) {
    const auto& of = mesh_.boundary[static_cast<std::size_t>(face)];
    const Reference& reference = reference_of(of.face, from, to);
    const auto geometry = elasticity::cell_geometry<3>(
        mesh_.cell_points[static_cast<std::size_t>(of.cell)],
        reference.geometry);
    EdgeSide side{face, reference.points, {}, {}, 0.0};
    for (int k = 0; k < kPoints; ++k) {
      const auto& inverse =
          geometry.inverse_jacobian[static_cast<std::size_t>(k)];
      side.normal.col(k) =
          (inverse.transpose() * reference.outward).normalized();
      side.along.col(k) = inverse.lu().solve(reference.along).normalized();
      if (k > 0) {
        side.length +=
            (geometry.points.col(k) - geometry.points.col(k - 1)).norm();
      }
    }
    return side;
  }

 private:
  struct Reference {
    EdgePoints points;
    elasticity::CellInterpolation<3> geometry;
    Vector3d outward, along;
  };

  const Reference& reference_of(int face, unsigned from, unsigned to) {
    const auto [at, is_new] = known_.try_emplace({face, from, to});
    if (is_new) {
      const Vector3d a = reference_vertex(mesh_.shape, from);
      const Vector3d b = reference_vertex(mesh_.shape, to);
      EdgePoints points;
      for (int k = 0; k < kPoints; ++k) {
        points.col(k) = a + (b - a) * k / double(kEdgeIntervals);
      }
      at->second = {
          points,
          elasticity::CellInterpolation<3>(mesh_.shape, mesh_.degree, points),
          elasticity::face_gauss<3>(mesh_.shape, face, 1).outward, b - a};
    }
    return at->second;
  }

  const mesh::PartMesh<3>& mesh_;
  std::map<std::tuple<int, unsigned, unsigned>, Reference> known_;
};

/// Angles between the normals of two sides [rad].
auto kink_between(const EdgeSide& one, const EdgeSide& other) {
  Eigen::Array<double, kPoints, 1> kink;
  for (int k = 0; k < kPoints; ++k) {
    const Vector3d a = one.normal.col(k);
    const Vector3d b = other.normal.col(k);
    kink[k] = std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return kink;
}

}  // namespace

std::vector<SurfaceEdge> smooth_edges(const mesh::PartMesh<3>& mesh,
                                      const std::vector<char>& wanted) {
  constexpr double kSmooth = 20.0 * std::numbers::pi / 180.0;
  EdgeSides sides(mesh);
  std::map<Edge, EdgeSide> first;
  std::vector<SurfaceEdge> edges;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& face = mesh.boundary[f];
    const auto& ids = mesh.cells[static_cast<std::size_t>(face.cell)];
    for (auto [from, to] : face_edges(mesh.shape, face.face)) {
      if (wanted[ids[from]] == 0 || wanted[ids[to]] == 0) continue;
      if (ids[from] > ids[to]) std::swap(from, to);
      const EdgeSide here = sides.side(static_cast<int>(f), from, to);
      const auto [at, is_first] =
          first.try_emplace(Edge{ids[from], ids[to]}, here);
      if (is_first) continue;
      const auto kink = kink_between(at->second, here);
      if (kink.maxCoeff() < kSmooth) edges.push_back({at->second, here, kink});
    }
  }
  return edges;
}

}  // namespace clevis::stress
