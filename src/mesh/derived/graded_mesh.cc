#include "mesh/derived/graded_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <utility>

#include "mesh/basis/tensor_basis.h"

namespace clevis::mesh {
namespace {

using Eigen::Index;
using Eigen::Matrix2Xd;
using Eigen::Vector2d;

/// A point of a cell: its vertex number in the new mesh, reference position.
struct Corner {
  unsigned vertex{};
  Vector2d xi;
};
using Quad = std::array<Corner, 4>;  // counter-clockwise

// Lexicographic corners and local faces, counter-clockwise from the first.
constexpr std::array<std::size_t, 4> kAround = {0, 1, 3, 2};
constexpr std::array<int, 4> kFace = {2, 1, 3, 0};

Vector2d reference_corner(std::size_t around) {
  return {kAround[around] & 1U ? 1.0 : 0.0, kAround[around] & 2U ? 1.0 : 0.0};
}

/// Builds a mesh whose cells are pieces of another's.
class Splitter {
 public:
  explicit Splitter(const PartMesh<2>& old)
      : old_(old), nodes_(gauss_lobatto(old.degree)) {
    new_ = old;
    new_.cells.clear();
    new_.cell_points.clear();
    new_.boundary.clear();
    group_.resize(old.cells.size());
    for (auto& faces : group_) faces.fill(kInside);
    for (const auto& face : old.boundary) {
      group_[static_cast<std::size_t>(face.cell)]
            [static_cast<std::size_t>(face.face)] = face.group;
    }
  }

  Corner corner(std::size_t cell, std::size_t around) const {
    return {old_.cells[cell][kAround[around % 4]],
            reference_corner(around % 4)};
  }

  /// The point at `share` of the way between two corners, made once for the
  /// two cells of an edge.
  Corner on_edge(std::size_t cell, const Corner& from, const Corner& to,
                 double share) {
    const Vector2d xi = from.xi + share * (to.xi - from.xi);
    const auto key = std::pair(std::min(from.vertex, to.vertex),
                               std::max(from.vertex, to.vertex));
    // Halving makes one point an edge, grading one at its vertex's end.
    const auto [entry, is_new] =
        edge_points_.emplace(key, new_.vertices.size());
    if (is_new) new_.vertices.push_back(position(cell, xi));
    return {static_cast<unsigned>(entry->second), xi};
  }

  Corner inside(std::size_t cell, const Vector2d& xi) {
    new_.vertices.push_back(position(cell, xi));
    return {static_cast<unsigned>(new_.vertices.size() - 1), xi};
  }

  /// Adds a piece of a cell; sides on the cell's own boundary inherit it.
  void add(std::size_t cell, const Quad& quad) {
    const int index = static_cast<int>(new_.cells.size());
    new_.cells.push_back(
        {quad[0].vertex, quad[1].vertex, quad[3].vertex, quad[2].vertex});
    new_.cell_points.push_back(points(cell, quad));
    for (std::size_t side = 0; side < 4; ++side) {
      const int face = old_face(quad[side].xi, quad[(side + 1) % 4].xi);
      if (face < 0) continue;
      const int group = group_[cell][static_cast<std::size_t>(face)];
      if (group != kInside) {
        new_.boundary.push_back({index, kFace[side], group});
      }
    }
  }

  /// Takes a cell over as it is.
  void keep(std::size_t cell) {
    const int index = static_cast<int>(new_.cells.size());
    new_.cells.push_back(old_.cells[cell]);
    new_.cell_points.push_back(old_.cell_points[cell]);
    for (int face = 0; face < 4; ++face) {
      const int group = group_[cell][static_cast<std::size_t>(face)];
      if (group != kInside) new_.boundary.push_back({index, face, group});
    }
  }

  PartMesh<2> take() { return std::move(new_); }

 private:
  static constexpr int kInside = -2;

  /// Face of the reference cell on which both points lie, or −1.
  static int old_face(const Vector2d& a, const Vector2d& b) {
    for (int d = 0; d < 2; ++d) {
      for (const int side : {0, 1}) {
        if (a[d] == side && b[d] == side) return 2 * d + side;
      }
    }
    return -1;
  }

  Vector2d position(std::size_t cell, const Vector2d& xi) const {
    const auto x = lagrange(nodes_, xi.head<1>());
    const auto y = lagrange(nodes_, xi.tail<1>());
    return interpolate<2>(old_.cell_points[cell], {&x.value, &y.value}).col(0);
  }

  Matrix2Xd points(std::size_t cell, const Quad& quad) const {
    const Index n = nodes_.size();
    Matrix2Xd result(2, n * n);
    for (Index j = 0; j < n; ++j) {
      for (Index i = 0; i < n; ++i) {
        const double s = nodes_[i];
        const double t = nodes_[j];
        result.col(i + n * j) = position(
            cell, (1 - s) * (1 - t) * quad[0].xi + s * (1 - t) * quad[1].xi +
                      s * t * quad[2].xi + (1 - s) * t * quad[3].xi);
      }
    }
    return result;
  }

  const PartMesh<2>& old_;
  Eigen::VectorXd nodes_;
  PartMesh<2> new_;
  std::vector<std::array<int, 4>> group_;  // per cell and local face
  std::map<std::pair<unsigned, unsigned>, std::size_t> edge_points_;
};

/// Which corner (counter-clockwise) of a cell is one of the vertices; −1 none.
int marked_corner(const std::vector<unsigned>& cell,
                  const std::vector<unsigned>& vertices) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (std::ranges::count(vertices, cell[kAround[k]]) > 0) {
      return static_cast<int>(k);
    }
  }
  return -1;
}

bool shares_a_cell(const PartMesh<2>& mesh,
                   const std::vector<unsigned>& vertices) {
  return std::ranges::any_of(mesh.cells, [&](const auto& cell) {
    return std::ranges::count_if(cell, [&](unsigned v) {
             return std::ranges::count(vertices, v) > 0;
           }) > 1;
  });
}

/// One more ring around every vertex.
GradedMesh add_ring(const GradedMesh& before) {
  const auto& old = before.mesh;
  Splitter splitter(old);
  GradedMesh after;
  after.vertices = before.vertices;
  const auto note = [&](int vertex, int ring) {
    after.vertex_of.push_back(vertex);
    after.ring.push_back(ring);
  };
  for (std::size_t c = 0; c < old.cells.size(); ++c) {
    const int marked = marked_corner(old.cells[c], before.vertices);
    if (marked < 0) {
      splitter.keep(c);
      note(before.vertex_of[c], before.ring[c]);
      continue;
    }
    const auto k = static_cast<std::size_t>(marked);
    const Corner tip = splitter.corner(c, k);
    const Corner right = splitter.corner(c, k + 1);
    const Corner across = splitter.corner(c, k + 2);
    const Corner left = splitter.corner(c, k + 3);
    const Corner a = splitter.on_edge(c, tip, right, kGradingRatio);
    const Corner b = splitter.on_edge(c, tip, left, kGradingRatio);
    const Corner m =
        splitter.inside(c, tip.xi + kGradingRatio * (across.xi - tip.xi));
    const int vertex =
        static_cast<int>(std::ranges::find(before.vertices, tip.vertex) -
                         before.vertices.begin());
    const int ring = std::max(before.ring[c], 0);
    splitter.add(c, {tip, a, m, b});
    note(vertex, ring + 1);
    splitter.add(c, {a, right, across, m});
    note(vertex, ring);
    splitter.add(c, {m, across, left, b});
    note(vertex, ring);
  }
  after.mesh = splitter.take();
  return after;
}

}  // namespace

PartMesh<2> halve_cells(const PartMesh<2>& mesh) {
  Splitter splitter(mesh);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Corner centre = splitter.inside(c, Vector2d(0.5, 0.5));
    std::array<Corner, 4> middle;
    for (std::size_t k = 0; k < 4; ++k) {
      middle[k] = splitter.on_edge(c, splitter.corner(c, k),
                                   splitter.corner(c, k + 1), 0.5);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      splitter.add(
          c, {splitter.corner(c, k), middle[k], centre, middle[(k + 3) % 4]});
    }
  }
  return splitter.take();
}

GradedMesh grade_at_vertices(PartMesh<2> mesh, std::vector<unsigned> vertices,
                             int layers) {
  assert(mesh.shape == CellShape::kTensor);
  // Halving keeps the old vertices' numbers.
  if (shares_a_cell(mesh, vertices)) mesh = halve_cells(mesh);
  GradedMesh graded;
  graded.vertex_of.assign(mesh.cells.size(), -1);
  graded.ring.assign(mesh.cells.size(), -1);
  graded.mesh = std::move(mesh);
  graded.vertices = std::move(vertices);
  for (int k = 0; k < layers; ++k) graded = add_ring(graded);
  return graded;
}

}  // namespace clevis::mesh
