#include "mesh/quality/mesh_validation.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/quality/simplex_quality.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Vector3d;

void take(const Eigen::Matrix3d& J, CellQuality& quality) {
  const double det = J.determinant();
  const double lengths = J.colwise().norm().prod();
  quality.min_jacobian = std::min(quality.min_jacobian, det);
  quality.max_jacobian = std::max(quality.max_jacobian, det);
  quality.scaled_jacobian =
      std::min(quality.scaled_jacobian, lengths > 0.0 ? det / lengths : 0.0);
}

constexpr double kHuge = std::numeric_limits<double>::infinity();
constexpr CellQuality kUnknown = {kHuge, -kHuge, kHuge};

CellQuality quality_at_nodes(const Eigen::Matrix3Xd& cell_points,
                             const LagrangeBasis& basis) {
  const auto tangents = tangents_at_nodes(cell_points, basis.slope);
  CellQuality quality = kUnknown;
  Eigen::Matrix3d J;
  for (Index q = 0; q < cell_points.cols(); ++q) {
    for (unsigned d = 0; d < 3; ++d) J.col(d) = tangents[d].col(q);
    take(J, quality);
  }
  return quality;
}

CellQuality quality_at(const Eigen::Matrix3Xd& cell_points,
                       const LagrangeBasis& basis) {
  const auto grid = map_grid<3>(cell_points, {&basis, &basis, &basis});
  CellQuality quality = kUnknown;
  for (Index q = 0; q < grid.points.cols(); ++q) {
    take(grid.jacobian(q), quality);
  }
  return quality;
}

/// Far from folding at the nodes. The maps are smooth blends, so such a cell
/// is not looked at in between; one in doubt is, at the finer points too.
bool is_sound(const CellQuality& quality) {
  return quality.min_jacobian > 0.25 * quality.max_jacobian &&
         quality.scaled_jacobian > 0.25;
}

/// A needle whose corner lies far off has next to no inside either. A corner of
/// 180°, which two sides on one curve make of a hexahedron, has no map: the
/// stress there is by chance.
bool is_bad(const CellQuality& quality, CellShape shape) {
  constexpr double kFlattest = 1e-5;
  constexpr double kFlattestCorner = 0.01;  // sine of its angle
  return !(quality.scaled_jacobian >
           (shape == CellShape::kTensor ? kFlattestCorner : kFlattest));
}

double straight_volume(const PartMesh<3>& mesh, std::size_t cell) {
  if (mesh.shape == CellShape::kSimplex) {
    Eigen::Matrix3d edges;
    for (std::size_t d = 0; d < 3; ++d) {
      edges.col(Index(d)) = mesh.vertices[mesh.cells[cell][d + 1]] -
                            mesh.vertices[mesh.cells[cell][0]];
    }
    return edges.determinant() / 6.0;
  }
  // Trilinear through the corners: two Gauss points are exact.
  Eigen::Matrix3Xd corners(3, 8);
  for (std::size_t v = 0; v < 8; ++v) {
    corners.col(Index(v)) = mesh.vertices[mesh.cells[cell][v]];
  }
  const LagrangeBasis basis = lagrange(gauss_lobatto(1), gauss(2).points);
  const auto grid = map_grid<3>(corners, {&basis, &basis, &basis});
  double volume = 0.0;
  for (Index q = 0; q < 8; ++q) volume += grid.jacobian(q).determinant() / 8.0;
  return volume;
}

Vector3d middle(const PartMesh<3>& mesh, std::size_t cell) {
  return mesh.cell_points[cell].rowwise().mean();
}

std::string in_mm(const Vector3d& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x(), 1e3 * p.y(),
                     1e3 * p.z());
}

}  // namespace

std::vector<CellQuality> cell_qualities(const PartMesh<3>& mesh) {
  if (mesh.shape == CellShape::kSimplex) {
    const SimplexQuality quality(mesh.degree);
    std::vector<CellQuality> qualities;
    for (const auto& points : mesh.cell_points) {
      qualities.push_back(quality.of(points));
    }
    return qualities;
  }
  const Eigen::VectorXd nodes = gauss_lobatto(mesh.degree);
  const LagrangeBasis at_nodes = lagrange(nodes, nodes);
  const Eigen::VectorXd inner = gauss(mesh.degree + 2).points;
  Eigen::VectorXd points(inner.size() + 2);
  points << 0.0, inner, 1.0;
  const LagrangeBasis at_points = lagrange(nodes, points);
  std::vector<CellQuality> qualities(mesh.cells.size(), kUnknown);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    qualities[c] = quality_at_nodes(mesh.cell_points[c], at_nodes);
    if (!is_sound(qualities[c])) {
      qualities[c] = quality_at(mesh.cell_points[c], at_points);
    }
  }
  return qualities;
}

void check_size(const PartMesh<3>& mesh, const std::string& file) {
  constexpr double kSmallest = 1e-5, kLargest = 100.0, kThinnest = 1e-6;
  const double size = size_of(mesh);
  if (size < kSmallest || size > kLargest) {
    throw Error("M007", file, fmt::format("the part is {:.3g} m large", size),
                "Check length_unit of the part.");
  }
  Vector3d low = mesh.vertices.front(), high = low;
  for (const Vector3d& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const double thickness = (high - low).minCoeff();
  if (thickness >= kThinnest && thickness >= kThinnest * size) return;
  throw Error("M007", file,
              fmt::format("the part is {:.3g} m large and {:.3g} m thick", size,
                          thickness),
              "Check thickness and length_unit of the part.");
}

void check_shapes(const PartMesh<3>& mesh, const std::string& file) {
  constexpr double kLongest = 5000.0;  // edge over edge of one cell
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    double shortest = kHuge, longest = 0.0;
    for (std::size_t i = 0; i < mesh.cells[c].size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const double apart =
            (mesh.vertices[mesh.cells[c][i]] - mesh.vertices[mesh.cells[c][k]])
                .norm();
        shortest = std::min(shortest, apart);
        longest = std::max(longest, apart);
      }
    }
    if (longest <= kLongest * shortest) continue;
    throw Error(
        "M005", file,
        fmt::format("cell {} near {} is {:.3g} mm long and {:.3g} mm "
                    "across",
                    c, in_mm(middle(mesh, c)), 1e3 * longest, 1e3 * shortest),
        "Look for a corner that lies far off, or mesh finer along "
        "the cell.");
  }
}

void check_connected(const PartMesh<3>& mesh, const std::string& file) {
  std::vector<int> piece(mesh.cells.size(), -1);
  const auto other = neighbours(mesh);
  int pieces = 0;
  for (std::size_t seed = 0; seed < piece.size(); ++seed) {
    if (piece[seed] >= 0) continue;
    std::vector<std::size_t> front = {seed};
    piece[seed] = pieces;
    while (!front.empty()) {
      const std::size_t cell = front.back();
      front.pop_back();
      for (const auto& [next, face] : other[cell]) {
        if (next < 0 || piece[std::size_t(next)] >= 0) continue;
        piece[std::size_t(next)] = pieces;
        front.push_back(std::size_t(next));
      }
    }
    ++pieces;
  }
  if (pieces <= 1) return;

  struct Piece {
    double volume{};
    int cells{};
    Vector3d at = Vector3d::Zero();
  };
  std::vector<Piece> list{std::size_t(pieces)};
  for (std::size_t c = 0; c < piece.size(); ++c) {
    Piece& p = list[std::size_t(piece[c])];
    if (p.cells++ == 0) p.at = middle(mesh, c);
    p.volume += straight_volume(mesh, c);
  }
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(list.size(), 5); ++i) {
    text += fmt::format("{} {:.4g} mm³ in {} cells near {}", i ? ";" : ":",
                        1e9 * list[i].volume, list[i].cells, in_mm(list[i].at));
  }
  throw Error("M006", file,
              fmt::format("the cells form {} pieces that share no face{}{}",
                          pieces, text, list.size() > 5 ? "; …" : ""),
              "Delete the loose piece, or merge coincident nodes (gmsh: "
              "Coherence Mesh).");
}

bool are_sound(const PartMesh<3>& mesh) {
  return std::ranges::none_of(cell_qualities(mesh), [&](const auto& quality) {
    return is_bad(quality, mesh.shape);
  });
}

void check_jacobians(const PartMesh<3>& mesh, const std::string& file) {
  const auto qualities = cell_qualities(mesh);
  std::vector<std::size_t> bad;
  bool all_inside_out = true;
  for (std::size_t c = 0; c < qualities.size(); ++c) {
    all_inside_out = all_inside_out && qualities[c].max_jacobian < 0.0;
    if (is_bad(qualities[c], mesh.shape)) bad.push_back(c);
  }
  if (bad.empty()) return;
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(bad.size(), 5); ++i) {
    text += fmt::format("{} cell {} near {}", i ? "," : ":", bad[i],
                        in_mm(middle(mesh, bad[i])));
  }
  throw Error(
      "M005", file,
      fmt::format("{} of {} cells are inverted or folded{}{}", bad.size(),
                  qualities.size(), text, bad.size() > 5 ? ", …" : ""),
      all_inside_out
          ? "The whole mesh is numbered left-handed: mirror the geometry, not "
            "the mesh, or reverse the elements."
          : "Mesh the place finer, so that no cell has two sides on one curve "
            "and no curved surface cuts through its cells.");
}

}  // namespace clevis::mesh
