#include "stress/peaks/surface_kink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/fe_space/tabulation.h"
#include "mesh/basis/simplex_basis.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Edge = std::pair<unsigned, unsigned>;  // lower vertex first

constexpr int kSamples = 5;
constexpr int kIntervals = kSamples - 1;

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

elasticity::ReferencePoints<3> edge_points(mesh::CellShape shape, unsigned from,
                                           unsigned to) {
  elasticity::ReferencePoints<3> points(3, kSamples);
  const Vector3d a = reference_vertex(shape, from);
  const Vector3d b = reference_vertex(shape, to);
  for (int k = 0; k < kSamples; ++k) {
    points.col(k) = a + (b - a) * k / double(kIntervals);
  }
  return points;
}

/// A face of the boundary beside an edge.
struct EdgeSide {
  Matrix3Xd normal;   ///< outward, unit
  Matrix3Xd along;    ///< of the edge, unit
  MatrixXd stress{};  ///< samples × 6 [Pa]; empty: not known
};

EdgeSide edge_side(const mesh::PartMesh<3>& mesh, mesh::BoundaryFace face,
                   unsigned from, unsigned to) {
  const auto points = edge_points(mesh.shape, from, to);
  const auto geometry = elasticity::cell_geometry<3>(
      mesh.cell_points[static_cast<std::size_t>(face.cell)],
      elasticity::tabulate_geometry<3>(mesh.shape, mesh.degree, points));
  const Vector3d outward =
      elasticity::face_gauss<3>(mesh.shape, face.face, 1).outward;
  const Vector3d direction = points.col(kIntervals) - points.col(0);
  EdgeSide side{Matrix3Xd(3, kSamples), Matrix3Xd(3, kSamples)};
  for (int k = 0; k < kSamples; ++k) {
    const auto& inverse =
        geometry.inverse_jacobian[static_cast<std::size_t>(k)];
    side.normal.col(k) = (inverse.transpose() * outward).normalized();
    side.along.col(k) = inverse.lu().solve(direction).normalized();
  }
  return side;
}

/// Rows of a lattice of kIntervals at the samples of an edge.
std::vector<Eigen::Index> edge_rows(mesh::CellShape shape, unsigned from,
                                    unsigned to) {
  const auto lattice = elasticity::lattice<3>(shape, kIntervals);
  const auto points = edge_points(shape, from, to);
  std::vector<Eigen::Index> rows(kSamples);
  for (int k = 0; k < kSamples; ++k) {
    (lattice.colwise() - points.col(k))
        .colwise()
        .squaredNorm()
        .minCoeff(&rows[static_cast<std::size_t>(k)]);
  }
  return rows;
}

/// The stress that flows across the edge in the surface [Pa].
double across(const EdgeSide& side, int sample) {
  if (side.stress.size() == 0) return 0.0;
  const Matrix3d stress = stress_tensor(side.stress.row(sample));
  const Vector3d direction =
      side.normal.col(sample).cross(side.along.col(sample)).normalized();
  return std::abs(direction.dot(stress * direction));
}

/// The largest angle between normals times the stress across the edge [Pa];
/// 0 if they belong to an edge of the part.
double bent_stress(const EdgeSide& one, const EdgeSide& other) {
  constexpr double kSmooth = 20.0 * std::numbers::pi / 180.0;
  double largest = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const Vector3d a = one.normal.col(k);
    const Vector3d b = other.normal.col(k);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (angle >= kSmooth) return 0.0;
    largest =
        std::max(largest, angle * std::max(across(one, k), across(other, k)));
  }
  return largest;
}

}  // namespace

double kinked_stress(const mesh::PartMesh<3>& mesh,
                     const std::vector<int>& cells,
                     const std::vector<MatrixXd>& stress) {
  std::map<int, std::size_t> place;
  for (std::size_t k = 0; k < cells.size(); ++k) place[cells[k]] = k;
  std::vector<char> is_near(mesh.vertices.size(), 0);
  for (const int cell : cells) {
    for (const unsigned v : mesh.cells[static_cast<std::size_t>(cell)]) {
      is_near[v] = 1;
    }
  }
  std::map<Edge, EdgeSide> first;
  double largest = 0.0;
  for (const auto& face : mesh.boundary) {
    const auto& ids = mesh.cells[static_cast<std::size_t>(face.cell)];
    for (auto [from, to] : face_edges(mesh.shape, face.face)) {
      if (is_near[ids[from]] == 0 || is_near[ids[to]] == 0) continue;
      if (ids[from] > ids[to]) std::swap(from, to);
      EdgeSide here = edge_side(mesh, face, from, to);
      const auto known = place.find(face.cell);
      if (known != place.end()) {
        here.stress =
            stress[known->second](edge_rows(mesh.shape, from, to), Eigen::all);
      }
      const auto at = first.try_emplace(Edge{ids[from], ids[to]}, here);
      if (at.second) continue;
      largest = std::max(largest, bent_stress(at.first->second, here));
    }
  }
  return largest;
}

}  // namespace clevis::stress
