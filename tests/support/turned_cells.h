#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::support {

/// A cell turned by a quarter about an axis of its reference directions (dim =
/// 2: about z): new corner c is the old one [c].
inline std::vector<unsigned> quarter_turn(int dim, int axis) {
  const int a = dim == 2 ? 0 : (axis + 1) % 3;
  const int b = dim == 2 ? 1 : (axis + 2) % 3;
  std::vector<unsigned> from;
  for (unsigned corner = 0; corner < (1U << dim); ++corner) {
    const unsigned in_a = (corner >> a) & 1U;
    const unsigned in_b = (corner >> b) & 1U;
    const unsigned rest = corner & ~((1U << a) | (1U << b));
    from.push_back(rest | ((1U - in_b) << a) | (in_a << b));
  }
  return from;
}

/// A mesh of degree 1 without its boundary, each cell turned at random.
template <int dim>
mesh::PartMesh<dim> with_turned_cells(mesh::PartMesh<dim> mesh) {
  std::mt19937 random(7);
  mesh.boundary.clear();
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (unsigned turns = random() % 12; turns > 0; --turns) {
      const auto from = quarter_turn(dim, static_cast<int>(random() % 3));
      const auto vertices = mesh.cells[c];
      const auto points = mesh.cell_points[c];
      for (std::size_t k = 0; k < from.size(); ++k) {
        mesh.cells[c][k] = vertices[from[k]];
        mesh.cell_points[c].col(static_cast<Eigen::Index>(k)) =
            points.col(from[k]);
      }
    }
  }
  return mesh;
}

/// A closed ring of hexahedra that turns by half a turn about its middle line:
/// no directions of its cells agree.
inline mesh::PartMesh<3> moebius_ring(unsigned cells) {
  mesh::PartMesh<3> mesh;
  mesh.degree = 1;
  for (unsigned s = 0; s < cells; ++s) {
    const double turn = 2.0 * 3.14159265358979 * s / cells;
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0.0);
    const Eigen::Vector3d a = std::cos(0.5 * turn) * out +
                              std::sin(0.5 * turn) * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d b = std::cos(0.5 * turn) * Eigen::Vector3d::UnitZ() -
                              std::sin(0.5 * turn) * out;
    for (const double y : {-0.2, 0.2}) {
      for (const double x : {-0.2, 0.2}) {
        mesh.vertices.emplace_back(2.0 * out + x * a + y * b);
      }
    }
  }
  for (unsigned s = 0; s < cells; ++s) {
    std::vector<unsigned> cell;
    for (unsigned k = 0; k < 4; ++k) cell.push_back(4 * s + k);
    for (unsigned k = 0; k < 4; ++k) {
      cell.push_back(s + 1 < cells ? 4 * (s + 1) + k : 3 - k);
    }
    Eigen::Matrix3Xd points(3, 8);
    for (unsigned k = 0; k < 8; ++k) points.col(k) = mesh.vertices[cell[k]];
    mesh.cells.push_back(cell);
    mesh.cell_points.push_back(points);
  }
  return mesh;
}

}  // namespace clevis::support
