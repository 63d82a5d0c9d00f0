#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "support/structured_mesh.h"

namespace clevis::support {

/// A plate whose corner at the origin has `angle` [rad] of material, from the
/// x-axis counter-clockwise: `sectors` quadrilaterals around it. Groups:
/// "side0" and "side1", the corner's sides; "start" and "end", the outer faces
/// next to them; "outer".
inline mesh::PartMesh<2> wedge_mesh(double angle, int sectors, double size,
                                    double thickness) {
  mesh::PartMesh<2> mesh;
  mesh.thickness = thickness;
  for (const char* name : {"side0", "side1", "start", "end", "outer"}) {
    mesh.groups.push_back({name, {}});
  }
  mesh.vertices.emplace_back(0.0, 0.0);
  const double step = angle / sectors;
  for (int k = 0; k <= 2 * sectors; ++k) {
    // A regular polygon with the rays' ends on its middles of sides.
    const double r = k % 2 == 0 ? size : size / std::cos(0.5 * step);
    mesh.vertices.emplace_back(r * std::cos(0.5 * step * k),
                               r * std::sin(0.5 * step * k));
  }
  for (int k = 0; k < sectors; ++k) {
    const auto first = static_cast<unsigned>(2 * k + 1);
    mesh.cells.push_back({0U, first, first + 2, first + 1});
    const auto& ids = mesh.cells.back();
    Eigen::Matrix2Xd points(2, 4);
    for (std::size_t v = 0; v < 4; ++v) {
      points.col(static_cast<Eigen::Index>(v)) = mesh.vertices[ids[v]];
    }
    mesh.cell_points.push_back(points);
    if (k == 0) mesh.boundary.push_back({k, 2, 0});
    if (k == sectors - 1) mesh.boundary.push_back({k, 0, 1});
    mesh.boundary.push_back({k, 1, k == 0 ? 2 : 4});
    mesh.boundary.push_back({k, 3, k == sectors - 1 ? 3 : 4});
  }
  return mesh;
}

/// A structured mesh without the cells that `keep` refuses (by their index).
/// Faces that come free are in the group "cut".
template <int dim>
mesh::PartMesh<dim> without_cells(
    const mesh::PartMesh<dim>& mesh, const std::array<int, dim>& divisions,
    const std::function<bool(const std::array<int, dim>&)>& keep) {
  const auto index_of = [&](int c) {
    std::array<int, dim> index{};
    for (std::size_t d = 0; d < dim; ++d) {
      index[d] = c % divisions[d];
      c /= divisions[d];
    }
    return index;
  };
  auto result = mesh;
  result.cells.clear();
  result.cell_points.clear();
  result.boundary.clear();
  result.groups.push_back({"cut", {}});
  const int cut = static_cast<int>(mesh.groups.size());
  std::vector<int> number(mesh.cells.size(), -1);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto index = index_of(static_cast<int>(c));
    if (!keep(index)) continue;
    number[c] = static_cast<int>(result.cells.size());
    result.cells.push_back(mesh.cells[c]);
    result.cell_points.push_back(mesh.cell_points[c]);
    for (std::size_t d = 0; d < dim; ++d) {
      for (const int side : {0, 1}) {
        auto other = index;
        other[d] += 2 * side - 1;
        if (other[d] < 0 || other[d] >= divisions[d] || keep(other)) continue;
        result.boundary.push_back(
            {number[c], 2 * static_cast<int>(d) + side, cut});
      }
    }
  }
  for (mesh::BoundaryFace face : mesh.boundary) {
    face.cell = number[static_cast<std::size_t>(face.cell)];
    if (face.cell >= 0) result.boundary.push_back(face);
  }
  std::vector<unsigned> to(mesh.vertices.size(), 0U);
  for (const auto& cell : result.cells) {
    for (const unsigned vertex : cell) to[vertex] = 1U;
  }
  result.vertices.clear();
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == 0U) continue;
    to[v] = static_cast<unsigned>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[v]);
  }
  for (auto& cell : result.cells) {
    for (unsigned& vertex : cell) vertex = to[vertex];
  }
  return result;
}

}  // namespace clevis::support
