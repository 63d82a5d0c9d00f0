#include "mesh/derived/sub_mesh.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <set>
#include <utility>

namespace clevis::mesh {

template <int dim>
SubMesh<dim> sub_mesh(const PartMesh<dim>& whole, std::vector<int> cells) {
  constexpr unsigned kAbsent = ~0U;
  SubMesh<dim> sub;
  PartMesh<dim>& mesh = sub.mesh;
  mesh.shape = whole.shape;
  mesh.degree = whole.degree;
  mesh.groups = whole.groups;
  mesh.thickness = whole.thickness;
  mesh.mid_plane_z = whole.mid_plane_z;
  std::vector<unsigned> vertex(whole.vertices.size(), kAbsent);
  std::vector<int> place(whole.cells.size(), -1);
  for (const int cell : cells) {
    const auto c = static_cast<std::size_t>(cell);
    place[c] = static_cast<int>(mesh.cells.size());
    auto& ids = mesh.cells.emplace_back();
    for (const unsigned v : whole.cells[c]) {
      if (vertex[v] == kAbsent) {
        vertex[v] = static_cast<unsigned>(mesh.vertices.size());
        mesh.vertices.push_back(whole.vertices[v]);
      }
      ids.push_back(vertex[v]);
    }
    mesh.cell_points.push_back(whole.cell_points[c]);
  }
  for (const BoundaryFace& face : whole.boundary) {
    const int at = place[static_cast<std::size_t>(face.cell)];
    if (at >= 0) mesh.boundary.push_back({at, face.face, face.group});
  }
  sub.cells = std::move(cells);
  return sub;
}

template <int dim>
std::vector<int> with_neighbours(const PartMesh<dim>& mesh,
                                 std::vector<int> cells, int layers) {
  std::vector<char> touched(mesh.vertices.size(), 0);
  for (int layer = 0; layer < layers; ++layer) {
    for (const int cell : cells) {
      for (const unsigned v : mesh.cells[static_cast<std::size_t>(cell)]) {
        touched[v] = 1;
      }
    }
    cells.clear();
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      if (std::ranges::any_of(mesh.cells[c], [&](unsigned v) {
            return touched[v] != 0;
          })) {
        cells.push_back(static_cast<int>(c));
      }
    }
  }
  return cells;
}

namespace {

template <int dim>
double longest_edge(const PartMesh<dim>& mesh, const std::vector<int>& cells) {
  double longest = 0.0;
  for (const int cell : cells) {
    const auto& ids = mesh.cells[static_cast<std::size_t>(cell)];
    for (std::size_t a = 0; a < ids.size(); ++a) {
      for (std::size_t b = a + 1; b < ids.size(); ++b) {
        // Vertices of tensor cells that differ in one direction alone.
        if (mesh.shape == CellShape::kTensor && !std::has_single_bit(a ^ b)) {
          continue;
        }
        longest = std::max(
            longest, (mesh.vertices[ids[a]] - mesh.vertices[ids[b]]).norm());
      }
    }
  }
  return longest;
}

/// Whether each vertex stands within a distance of one of the cells'.
template <int dim>
std::vector<char> close_vertices(const PartMesh<dim>& mesh,
                                 const std::vector<int>& cells,
                                 double distance) {
  std::set<unsigned> from;
  for (const int cell : cells) {
    const auto& ids = mesh.cells[static_cast<std::size_t>(cell)];
    from.insert(ids.begin(), ids.end());
  }
  std::vector<char> is_close(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < is_close.size(); ++v) {
    is_close[v] = std::ranges::any_of(from, [&](unsigned other) {
      return (mesh.vertices[v] - mesh.vertices[other]).norm() < distance;
    });
  }
  return is_close;
}

/// The cells and those with a close vertex that are joined to them, as long as
/// they are not too many.
template <int dim>
std::vector<int> with_close_ones(const PartMesh<dim>& mesh,
                                 std::vector<int> cells,
                                 const std::vector<char>& is_close) {
  constexpr std::size_t kMost = 200;
  while (true) {
    std::vector<int> more;
    for (const int cell : with_neighbours(mesh, cells)) {
      const auto& ids = mesh.cells[static_cast<std::size_t>(cell)];
      if (std::ranges::binary_search(cells, cell) ||
          std::ranges::any_of(ids, [&](unsigned v) {
            return is_close[v] != 0;
          })) {
        more.push_back(cell);
      }
    }
    if (more.size() == cells.size() || more.size() > kMost) return cells;
    cells = std::move(more);
  }
}

}  // namespace

template <int dim>
std::vector<int> surroundings(const PartMesh<dim>& mesh,
                              const std::vector<int>& centre, int layers) {
  constexpr double kShare = 0.5;  // of the longest edge, per layer
  const double reach = kShare * longest_edge(mesh, centre);
  std::vector<int> cells = centre;
  for (int layer = 1; layer <= layers; ++layer) {
    cells = with_close_ones(mesh, with_neighbours(mesh, cells),
                            close_vertices(mesh, centre, layer * reach));
  }
  return cells;
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template SubMesh<dim> sub_mesh<dim>(const PartMesh<dim>&, std::vector<int>); \
  template std::vector<int> with_neighbours<dim>(const PartMesh<dim>&,         \
                                                 std::vector<int>, int);       \
  template std::vector<int> surroundings<dim>(const PartMesh<dim>&,            \
                                              const std::vector<int>&, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::mesh
