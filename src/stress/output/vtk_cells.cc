#include "stress/output/vtk_cells.h"

#include <array>
#include <cstddef>

#include "mesh/basis/simplex_basis.h"

namespace clevis::stress {
namespace {

constexpr std::uint8_t kTriangle = 5, kQuad = 9, kTetrahedron = 10,
                       kHexahedron = 12, kLagrangeQuad = 70,
                       kLagrangeHexahedron = 72;

/// Corners of a square, counterclockwise.
constexpr std::array<std::array<int, 2>, 4> kRound = {
    {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// Number of a point of a lattice with n intervals a direction.
int number(int n, int i, int j, int k = 0) {
  return i + (n + 1) * (j + (n + 1) * k);
}

/// Sides of a lid (z = k): along x, y, x, y.
void append_lid_edges(int n, int k, std::vector<int>& points) {
  for (int i = 1; i < n; ++i) points.push_back(number(n, i, 0, k));
  for (int j = 1; j < n; ++j) points.push_back(number(n, n, j, k));
  for (int i = 1; i < n; ++i) points.push_back(number(n, i, n, k));
  for (int j = 1; j < n; ++j) points.push_back(number(n, 0, j, k));
}

void append_lid_inside(int n, int k, std::vector<int>& points) {
  for (int j = 1; j < n; ++j) {
    for (int i = 1; i < n; ++i) points.push_back(number(n, i, j, k));
  }
}

std::vector<int> lagrange_quad(int n) {
  std::vector<int> points;
  for (const auto& [x, y] : kRound) points.push_back(number(n, n * x, n * y));
  append_lid_edges(n, 0, points);
  append_lid_inside(n, 0, points);
  return points;
}

/// As files of version 0.1 have it: of the upright edges the third stands at
/// (0, 1), the last at (1, 1).
std::vector<int> lagrange_hexahedron(int n) {
  std::vector<int> points;
  for (const int k : {0, n}) {
    for (const auto& [x, y] : kRound) {
      points.push_back(number(n, n * x, n * y, k));
    }
  }
  for (const int k : {0, n}) append_lid_edges(n, k, points);
  for (const int j : {0, n}) {
    for (const int i : {0, n}) {
      for (int k = 1; k < n; ++k) points.push_back(number(n, i, j, k));
    }
  }
  for (const int i : {0, n}) {
    for (int k = 1; k < n; ++k) {
      for (int j = 1; j < n; ++j) points.push_back(number(n, i, j, k));
    }
  }
  for (const int j : {0, n}) {
    for (int k = 1; k < n; ++k) {
      for (int i = 1; i < n; ++i) points.push_back(number(n, i, j, k));
    }
  }
  for (const int k : {0, n}) append_lid_inside(n, k, points);
  for (int k = 1; k < n; ++k) append_lid_inside(n, k, points);
  return points;
}

}  // namespace

template <int dim>
VtkCells lagrange_cell(int subdivisions) {
  if (dim == 2) return {kLagrangeQuad, {lagrange_quad(subdivisions)}};
  return {kLagrangeHexahedron, {lagrange_hexahedron(subdivisions)}};
}

template <int dim>
VtkCells linear_cells(mesh::CellShape shape, int subdivisions) {
  const int n = subdivisions;
  if (shape == mesh::CellShape::kSimplex) {
    VtkCells cells{dim == 2 ? kTriangle : kTetrahedron};
    for (const auto& part : mesh::simplex_parts<dim>(n)) {
      cells.points.emplace_back(part.begin(), part.end());
    }
    return cells;
  }
  VtkCells cells{dim == 2 ? kQuad : kHexahedron};
  for (int k = 0; k < (dim == 2 ? 1 : n); ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        auto& points = cells.points.emplace_back();
        for (int z = k; z < k + dim - 1; ++z) {
          for (const auto& [x, y] : kRound) {
            points.push_back(number(n, i + x, j + y, z));
          }
        }
      }
    }
  }
  return cells;
}

template VtkCells lagrange_cell<2>(int);
template VtkCells lagrange_cell<3>(int);
template VtkCells linear_cells<2>(mesh::CellShape, int);
template VtkCells linear_cells<3>(mesh::CellShape, int);

}  // namespace clevis::stress
