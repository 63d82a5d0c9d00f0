#include "mesher/surface_flips.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmsh.h>

namespace clevis::mesher {
namespace {

using Eigen::Vector3d;
using Node = std::size_t;  // gmsh's tag
using Triangle = std::array<Node, 3>;
using Tetrahedron = std::array<Node, 4>;

constexpr int kTriangle3 = 2, kTetrahedron4 = 4;  // gmsh's numbers of types

/// Nodes inside an entity, with their places on it.
struct OwnNodes {
  std::vector<Node> tags;
  std::vector<double> points, parameters;
};

OwnNodes own_nodes(int dim, int tag) {
  OwnNodes own;
  gmsh::model::mesh::getNodes(own.tags, own.points, own.parameters, dim, tag,
                              false, dim == 2);
  return own;
}

template <std::size_t corners>
std::vector<std::array<Node, corners>> cells_of(int type, int tag) {
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(type, tags, nodes, tag);
  std::vector<std::array<Node, corners>> cells(nodes.size() / corners);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    cells[i / corners][i % corners] = nodes[i];
  }
  return cells;
}

template <std::size_t corners>
std::vector<Node> nodes_of(
    const std::vector<std::array<Node, corners>>& cells) {
  std::vector<Node> nodes;
  for (const auto& cell : cells) {
    nodes.insert(nodes.end(), cell.begin(), cell.end());
  }
  return nodes;
}

Triangle ascending(Triangle nodes) {
  std::ranges::sort(nodes);
  return nodes;
}

/// Two triangles of one surface that are faces of one cell, oriented as they
/// are there, and what they become.
struct Flip {
  std::size_t cell{};
  int surface{};
  std::array<Triangle, 2> before, after;
  std::pair<Node, Node> edge;  ///< new one, ascending
};

class SurfaceMesh {
 public:
  SurfaceMesh() {
    std::vector<Node> tags;
    std::vector<double> points, unused;
    gmsh::model::mesh::getNodes(tags, points, unused);
    for (std::size_t i = 0; i < tags.size(); ++i) {
      points_[tags[i]] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    }
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto& [dim, tag] : surfaces) {
      for (const Triangle& nodes : cells_of<3>(kTriangle3, tag)) {
        faces_[ascending(nodes)] = {tag, nodes};
        for (std::size_t k = 0; k < 3; ++k) {
          edges_.insert(std::minmax(nodes[k], nodes[(k + 1) % 3]));
        }
      }
    }
  }

  std::optional<Flip> flip_of(std::size_t number,
                              const Tetrahedron& cell) const {
    std::vector<std::size_t> across;  // nodes opposite to faces on a surface
    for (std::size_t k = 0; k < 4; ++k) {
      if (faces_.contains(face_of(cell, k))) across.push_back(k);
    }
    if (across.size() != 2) return std::nullopt;
    const auto& [surface, first] = faces_.at(face_of(cell, across[0]));
    const auto& [other, second] = faces_.at(face_of(cell, across[1]));
    if (surface != other) return std::nullopt;
    // The first triangle lacks c, the second d: it has d across the edge.
    const Node c = cell[across[0]], d = cell[across[1]];
    const auto at =
        static_cast<std::size_t>(std::ranges::find(first, d) - first.begin());
    const Node a = first[(at + 1) % 3], b = first[(at + 2) % 3];
    Flip flip{.cell = number,
              .surface = surface,
              .before = {first, second},
              .after = {Triangle{d, a, c}, Triangle{c, b, d}},
              .edge = std::minmax(c, d)};
    if (edges_.contains(flip.edge)) return std::nullopt;
    const Vector3d old = area(first) + area(second);
    constexpr double kLeast = 0.05;  // of both, that a triangle may get
    for (const Triangle& made : flip.after) {
      if (area(made).dot(old) < kLeast * old.squaredNorm()) return std::nullopt;
    }
    return flip;
  }

 private:
  static Triangle face_of(const Tetrahedron& cell, std::size_t across) {
    Triangle face{};
    std::size_t next = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k != across) face[next++] = cell[k];
    }
    return ascending(face);
  }

  Vector3d area(const Triangle& nodes) const {
    const Vector3d& a = points_.at(nodes[0]);
    return (points_.at(nodes[1]) - a).cross(points_.at(nodes[2]) - a);
  }

  std::map<Node, Vector3d> points_;
  std::map<Triangle, std::pair<int, Triangle>> faces_;
  std::set<std::pair<Node, Node>> edges_;
};

/// Those that share no triangle and make no edge twice.
std::vector<Flip> flips_of(const std::vector<Tetrahedron>& cells) {
  const SurfaceMesh surface;
  std::vector<Flip> flips;
  std::set<std::pair<Node, Node>> made;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto flip = surface.flip_of(c, cells[c]);
    if (flip && made.insert(flip->edge).second) flips.push_back(*flip);
  }
  return flips;
}

void make(const std::vector<Flip>& flips, int volume,
          std::vector<Tetrahedron> cells) {
  std::map<int, std::vector<Triangle>> triangles;  // of each surface
  for (const Flip& flip : flips) {
    auto& own = triangles[flip.surface];
    if (own.empty()) own = cells_of<3>(kTriangle3, flip.surface);
    for (std::size_t k = 0; k < 2; ++k) {
      *std::ranges::find(own, flip.before[k]) = flip.after[k];
    }
  }
  for (auto flip = flips.rbegin(); flip != flips.rend(); ++flip) {
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(flip->cell));
  }
  // gmsh clears no surface whose volume has cells.
  const OwnNodes inside = own_nodes(3, volume);
  gmsh::model::mesh::clear({{3, volume}});
  for (const auto& [tag, own] : triangles) {
    const OwnNodes nodes = own_nodes(2, tag);
    gmsh::model::mesh::clear({{2, tag}});
    gmsh::model::mesh::addNodes(2, tag, nodes.tags, nodes.points,
                                nodes.parameters);
    gmsh::model::mesh::addElementsByType(tag, kTriangle3, {}, nodes_of(own));
  }
  gmsh::model::mesh::addNodes(3, volume, inside.tags, inside.points);
  gmsh::model::mesh::addElementsByType(volume, kTetrahedron4, {},
                                       nodes_of(cells));
}

}  // namespace

void flip_surface_edges() {
  constexpr int kMostRounds = 5;  // a flip can give the next cell two faces
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  const int volume = volumes.at(0).second;
  for (int round = 0; round < kMostRounds; ++round) {
    const auto cells = cells_of<4>(kTetrahedron4, volume);
    const std::vector<Flip> flips = flips_of(cells);
    if (flips.empty()) return;
    make(flips, volume, cells);
  }
}

}  // namespace clevis::mesher
