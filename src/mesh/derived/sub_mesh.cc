#include "mesh/derived/sub_mesh.h"

#include <algorithm>
#include <cstddef>
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

#define CLEVIS_INSTANTIATE(dim)                                                \
  template SubMesh<dim> sub_mesh<dim>(const PartMesh<dim>&, std::vector<int>); \
  template std::vector<int> with_neighbours<dim>(const PartMesh<dim>&,         \
                                                 std::vector<int>, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::mesh
