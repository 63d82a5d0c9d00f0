#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

#include <Eigen/LU>

#include "mesh/basis/simplex_basis.h"
#include "support/structured_mesh.h"

namespace clevis::support {

/// structured_mesh with every cell cut into triangles or tetrahedra about its
/// diagonal (Kuhn), with the same groups; each is mapped on its own, so that
/// all its edges are curved.
template <int dim>
mesh::PartMesh<dim> simplex_mesh(
    std::array<int, dim> divisions, int degree,
    const std::function<Eigen::Matrix<double, dim, 1>(
        const Eigen::Matrix<double, dim, 1>&)>& map) {
  using Point = Eigen::Matrix<double, dim, 1>;
  const auto grid = structured_mesh<dim>(divisions, 1, [](const Point& x) {
    return x;
  });
  mesh::PartMesh<dim> mesh;
  mesh.shape = mesh::CellShape::kSimplex;
  mesh.degree = degree;
  mesh.groups = grid.groups;
  for (const Point& x : grid.vertices) mesh.vertices.push_back(map(x));
  const auto nodes = mesh::simplex_nodes<dim>(degree);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    std::array<unsigned, dim> axes{};
    std::iota(axes.begin(), axes.end(), 0U);
    do {
      std::array<unsigned, dim + 1> corner{};
      for (std::size_t k = 0; k < dim; ++k) {
        corner[k + 1] = corner[k] | (1U << axes[k]);
      }
      const auto edges = [&] {
        Eigen::Matrix<double, dim, dim> columns;
        for (std::size_t k = 0; k < dim; ++k) {
          columns.col(static_cast<Eigen::Index>(k)) =
              grid.vertices[grid.cells[c][corner[k + 1]]] -
              grid.vertices[grid.cells[c][corner[0]]];
        }
        return columns;
      };
      if (edges().determinant() < 0.0) {
        std::swap(corner[dim - 1], corner[dim]);
      }
      const int cell = static_cast<int>(mesh.cells.size());
      auto& ids = mesh.cells.emplace_back();
      for (const unsigned v : corner) ids.push_back(grid.cells[c][v]);
      auto points = (edges() * nodes).eval();
      points.colwise() += grid.vertices[ids[0]];
      for (auto point : points.colwise()) point = map(point);
      mesh.cell_points.push_back(points);
      for (const auto& face : grid.boundary) {
        if (face.cell != static_cast<int>(c)) continue;
        const auto side = static_cast<unsigned>(face.face % 2);
        for (int f = 0; f < dim + 1; ++f) {
          const auto& vertices = mesh::simplex_face<dim>(f);
          const bool on_side = std::ranges::all_of(vertices, [&](int v) {
            return ((corner[static_cast<std::size_t>(v)] >> (face.face / 2)) &
                    1U) == side;
          });
          if (on_side) mesh.boundary.push_back({cell, f, face.group});
        }
      }
    } while (std::ranges::next_permutation(axes).found);
  }
  return mesh;
}

}  // namespace clevis::support
