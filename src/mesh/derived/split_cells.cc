#include "mesh/derived/split_cells.h"

#include <array>
#include <cassert>
#include <map>
#include <utility>

#include "mesh/basis/tensor_basis.h"

namespace clevis::mesh {
namespace {

using Place = std::array<int, 3>;

/// A lattice point of a cell by the vertices it is a mean of, with their
/// weights times n³: the same from every cell that holds the point, whatever
/// its position, so that no distance decides what is one point.
using Mean = std::vector<std::pair<unsigned, int>>;

Mean mean_of(const std::vector<unsigned>& corners, const Place& at, int n) {
  std::map<unsigned, int> weights;
  for (unsigned v = 0; v < 8; ++v) {
    int weight = 1;
    for (unsigned d = 0; d < 3; ++d) {
      weight *= ((v >> d) & 1U) != 0 ? at[d] : n - at[d];
    }
    if (weight != 0) weights[corners[v]] += weight;
  }
  return {weights.begin(), weights.end()};
}

/// Calls take(i, j, k) for the pieces of a cell in their order.
template <class Take>
void for_pieces(int n, Take take) {
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) take(Place{i, j, k});
    }
  }
}

/// Vertices of a piece; new ones are placed at the piece's corner points.
std::vector<unsigned> piece_vertices(const std::vector<unsigned>& corners,
                                     const Place& piece, int n,
                                     const Eigen::Matrix3Xd& points, int degree,
                                     std::map<Mean, unsigned>& known,
                                     std::vector<Eigen::Vector3d>& vertices) {
  std::vector<unsigned> result;
  for (int v = 0; v < 8; ++v) {
    const Place side = {v & 1, (v >> 1) & 1, v >> 2};
    const Place at = {piece[0] + side[0], piece[1] + side[1],
                      piece[2] + side[2]};
    const auto [entry, is_new] = known.try_emplace(
        mean_of(corners, at, n), static_cast<unsigned>(vertices.size()));
    if (is_new) {
      const int row = degree + 1;
      vertices.push_back(
          points.col(degree * (side[0] + row * (side[1] + row * side[2]))));
    }
    result.push_back(entry->second);
  }
  return result;
}

}  // namespace

PartMesh<3> split_cells(const PartMesh<3>& mesh, int n) {
  assert(mesh.shape == CellShape::kTensor && n >= 1);
  PartMesh<3> result = mesh;
  result.vertices.clear();
  result.cells.clear();
  result.cell_points.clear();
  result.boundary.clear();
  const Eigen::VectorXd nodes = gauss_lobatto(mesh.degree);
  std::vector<Eigen::MatrixXd> basis;  // of each n-th of a direction
  for (int i = 0; i < n; ++i) {
    basis.push_back(lagrange(nodes, (nodes.array() + i) / n).value);
  }
  std::map<Mean, unsigned> known;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for_pieces(n, [&](const Place& piece) {
      const auto along = [&](std::size_t d) {
        return &basis[static_cast<std::size_t>(piece[d])];
      };
      result.cell_points.push_back(
          interpolate<3>(mesh.cell_points[c], {along(0), along(1), along(2)}));
      result.cells.push_back(
          piece_vertices(mesh.cells[c], piece, n, result.cell_points.back(),
                         mesh.degree, known, result.vertices));
    });
  }
  for (const auto& face : mesh.boundary) {
    const int layer = face.face % 2 == 0 ? 0 : n - 1;
    for_pieces(n, [&](const Place& piece) {
      if (piece[static_cast<std::size_t>(face.face / 2)] != layer) return;
      const int child =
          piece[0] + n * (piece[1] + n * (piece[2] + n * face.cell));
      result.boundary.push_back({child, face.face, face.group});
    });
  }
  return result;
}

PartMesh<3> refined(const PartMesh<3>& mesh, int n) {
  PartMesh<3> result = split_cells(mesh, n);
  if (n == 1 || result.degree <= kPieceDegree) return result;
  const Eigen::MatrixXd down =
      lagrange(gauss_lobatto(result.degree), gauss_lobatto(kPieceDegree)).value;
  for (auto& points : result.cell_points) {
    points = interpolate<3>(points, {&down, &down, &down});
  }
  result.degree = kPieceDegree;
  return result;
}

}  // namespace clevis::mesh
