#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::support {

/// Gauss–Lobatto points on [0, 1]: ends and zeros of P'_degree, by Newton.
inline std::vector<double> gauss_lobatto(int degree) {
  std::vector<double> points(static_cast<std::size_t>(degree) + 1);
  for (int i = 0; i <= degree; ++i) {
    double x = -std::cos(std::numbers::pi * i / degree);
    for (int iteration = 0; i > 0 && i < degree && iteration < 50;
         ++iteration) {
      double before = 1.0;
      double here = x;
      for (int k = 2; k <= degree; ++k) {
        const double next = ((2 * k - 1) * x * here - (k - 1) * before) / k;
        before = here;
        here = next;
      }
      // (1 − x²) P' = n (P_{n−1} − x P_n); its derivative is −n (n + 1) P_n.
      x += (before - x * here) / ((degree + 1) * here);
    }
    points[static_cast<std::size_t>(i)] = 0.5 * (1.0 + x);
  }
  return points;
}

/// A tensor grid on [0, 1]^dim mapped by `map`, its geometry interpolated with
/// `degree` per cell. Groups "x0", "x1", "y0", … name the six (four) sides.
template <int dim>
mesh::PartMesh<dim> structured_mesh(
    std::array<int, dim> divisions, int degree,
    const std::function<Eigen::Matrix<double, dim, 1>(
        const Eigen::Matrix<double, dim, 1>&)>& map) {
  using Point = Eigen::Matrix<double, dim, 1>;
  mesh::PartMesh<dim> mesh;
  mesh.degree = degree;
  const auto lobatto = gauss_lobatto(degree);
  const auto at = [&](const std::array<int, dim>& index) {
    unsigned result = 0;
    for (int d = dim - 1; d >= 0; --d) {
      const auto k = static_cast<std::size_t>(d);
      result = result * static_cast<unsigned>(divisions[k] + 1) +
               static_cast<unsigned>(index[k]);
    }
    return result;
  };
  const auto for_each = [](const std::array<int, dim>& ends, auto&& body) {
    std::array<int, dim> index{};
    for (;;) {
      body(index);
      std::size_t d = 0;
      while (d < dim && ++index[d] == ends[d]) index[d++] = 0;
      if (d == dim) return;
    }
  };
  std::array<int, dim> corners = divisions;
  for (int& n : corners) ++n;
  for_each(corners, [&](const std::array<int, dim>& index) {
    Point x;
    for (std::size_t d = 0; d < dim; ++d) {
      x[static_cast<Eigen::Index>(d)] =
          static_cast<double>(index[d]) / divisions[d];
    }
    mesh.vertices.push_back(map(x));
  });
  for (const char* side : {"x0", "x1", "y0", "y1", "z0", "z1"}) {
    if (mesh.groups.size() < 2 * dim) mesh.groups.push_back({side, {}});
  }
  for_each(divisions, [&](const std::array<int, dim>& cell) {
    const int c = static_cast<int>(mesh.cells.size());
    std::vector<unsigned> ids;
    for (unsigned v = 0; v < (1U << dim); ++v) {
      std::array<int, dim> corner = cell;
      for (std::size_t d = 0; d < dim; ++d) corner[d] += (v >> d) & 1U;
      ids.push_back(at(corner));
    }
    mesh.cells.push_back(ids);
    std::array<int, dim> ends;
    ends.fill(degree + 1);
    Eigen::Matrix<double, dim, Eigen::Dynamic> points(
        dim, static_cast<Eigen::Index>(std::pow(degree + 1, dim) + 0.5));
    Eigen::Index q = 0;
    for_each(ends, [&](const std::array<int, dim>& node) {
      Point x;
      for (std::size_t d = 0; d < dim; ++d) {
        x[static_cast<Eigen::Index>(d)] =
            (cell[d] + lobatto[static_cast<std::size_t>(node[d])]) /
            divisions[d];
      }
      points.col(q++) = map(x);
    });
    mesh.cell_points.push_back(points);
    for (int d = 0; d < dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      if (cell[k] == 0) mesh.boundary.push_back({c, 2 * d, 2 * d});
      if (cell[k] + 1 == divisions[k]) {
        mesh.boundary.push_back({c, 2 * d + 1, 2 * d + 1});
      }
    }
  });
  return mesh;
}

}  // namespace clevis::support
