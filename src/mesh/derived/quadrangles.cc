#include "mesh/derived/quadrangles.h"

#include <array>
#include <cassert>
#include <map>
#include <utility>

#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::mesh {
namespace {

using Eigen::Index;
using Eigen::Matrix2Xd;
using Eigen::Vector2d;

const std::array<Vector2d, 3> kCorner = {Vector2d(0, 0), Vector2d(1, 0),
                                         Vector2d(0, 1)};

Vector2d middle(std::size_t side) {
  return 0.5 * (kCorner[side] + kCorner[(side + 1) % 3]);
}

/// Reference points of piece k, at the tensor grid of `nodes`: from corner k
/// along side k, then to the centre.
Matrix2Xd piece_points(std::size_t k, const Eigen::VectorXd& nodes) {
  const Vector2d centre(1.0 / 3.0, 1.0 / 3.0);
  const Index n = nodes.size();
  Matrix2Xd points(2, n * n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const double s = nodes[i];
      const double t = nodes[j];
      points.col(i + n * j) = (1 - s) * (1 - t) * kCorner[k] +
                              s * (1 - t) * middle(k) + s * t * centre +
                              (1 - s) * t * middle((k + 2) % 3);
    }
  }
  return points;
}

/// Side k, from corner k to the next, of a face of the reference triangle.
std::size_t side_of_face(int face) {
  const auto& ends = simplex_face<2>(face);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = static_cast<int>(k);
    const auto b = static_cast<int>((k + 1) % 3);
    if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a)) {
      return k;
    }
  }
  assert(false && "a triangle has three sides");
  return 0;
}

}  // namespace

PartMesh<2> quadrangles_of(const PartMesh<2>& triangles) {
  assert(triangles.shape == CellShape::kSimplex);
  const Eigen::VectorXd nodes = gauss_lobatto(triangles.degree);
  std::array<SimplexTable<2>, 3> tables;
  for (std::size_t k = 0; k < 3; ++k) {
    tables[k] = simplex_lagrange<2>(triangles.degree, piece_points(k, nodes));
  }
  PartMesh<2> result = triangles;
  result.shape = CellShape::kTensor;
  result.cells.clear();
  result.cell_points.clear();
  result.boundary.clear();
  std::map<std::pair<unsigned, unsigned>, unsigned> middles;
  const Index last = nodes.size() - 1;
  const Index far = nodes.size() * nodes.size() - 1;
  for (std::size_t c = 0; c < triangles.cells.size(); ++c) {
    const auto& vertices = triangles.cells[c];
    std::array<Matrix2Xd, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = map_simplex<2>(triangles.cell_points[c], tables[k]).points;
    }
    std::array<unsigned, 3> middle_vertex{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ends = std::minmax(vertices[k], vertices[(k + 1) % 3]);
      const auto [entry, is_new] =
          middles.emplace(ends, static_cast<unsigned>(result.vertices.size()));
      if (is_new) result.vertices.emplace_back(points[k].col(last));
      middle_vertex[k] = entry->second;
    }
    const auto centre = static_cast<unsigned>(result.vertices.size());
    result.vertices.emplace_back(points[0].col(far));
    for (std::size_t k = 0; k < 3; ++k) {
      result.cells.push_back(
          {vertices[k], middle_vertex[k], middle_vertex[(k + 2) % 3], centre});
      result.cell_points.push_back(points[k]);
    }
  }
  for (const BoundaryFace& face : triangles.boundary) {
    const std::size_t side = side_of_face(face.face);
    const int first = 3 * face.cell;
    // From corner `side` to the middle, and from there to the next corner.
    result.boundary.push_back({first + static_cast<int>(side), 2, face.group});
    result.boundary.push_back(
        {first + static_cast<int>((side + 1) % 3), 0, face.group});
  }
  return result;
}

}  // namespace clevis::mesh
