#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "part/bore.h"
#include "support/structured_mesh.h"

namespace clevis::support {

/// A round plate with a hole, or a sector of it.
struct Annulus {
  double inner{};                      ///< radius [m]
  double outer{};                      ///< radius [m]
  double thickness = 0.01;             ///< along z, from 0 [m]
  double start{};                      ///< first angle [rad]
  double span = std::numbers::pi / 2;  ///< of the sector [rad]
  int radial{}, angular{}, axial = 1;  ///< cells
  int degree = 4;                      ///< of the geometry
  /// Mesh lines where they are not even: fractions of the span, and of the way
  /// from log inner to log outer, from 0 to 1; one more than cells.
  std::vector<double> angle_lines{}, radius_lines{};
};

/// `x` of evenly spaced lines moved to the given ones, linear in between.
inline double on_lines(const std::vector<double>& lines, double x) {
  if (lines.empty()) return x;
  const double position = x * static_cast<double>(lines.size() - 1);
  const auto cell =
      std::min(static_cast<std::size_t>(position + 1e-9), lines.size() - 2);
  const double rest = position - static_cast<double>(cell);
  return (1.0 - rest) * lines[cell] + rest * lines[cell + 1];
}

/// Sector with radii in geometric progression. Groups
/// as in structured_mesh: x0 the bore, x1 the rim, y0 and y1 the two cuts, z0
/// and z1 the faces.
template <int dim>
mesh::PartMesh<dim> sector_mesh(const Annulus& annulus) {
  using Point = Eigen::Matrix<double, dim, 1>;
  std::array<int, dim> divisions{};
  divisions[0] = annulus.radial;
  divisions[1] = annulus.angular;
  if constexpr (dim == 3) divisions[2] = annulus.axial;
  auto mesh = structured_mesh<dim>(
      divisions, annulus.degree, [&](const Point& x) -> Point {
        const double r =
            annulus.inner * std::pow(annulus.outer / annulus.inner,
                                     on_lines(annulus.radius_lines, x[0]));
        const double angle =
            annulus.start + annulus.span * on_lines(annulus.angle_lines, x[1]);
        Point p;
        p[0] = r * std::cos(angle);
        p[1] = r * std::sin(angle);
        if constexpr (dim == 3) p[2] = annulus.thickness * x[2];
        return p;
      });
  if (dim == 2) mesh.thickness = annulus.thickness;
  part::Bore bore;
  bore.p_LC = {0.0, 0.0, dim == 3 ? annulus.thickness / 2 : 0.0};
  bore.axis_L = Eigen::Vector3d::UnitZ();
  bore.radius = annulus.inner;
  bore.length = annulus.thickness;
  mesh.groups[0].cylinder = bore;
  return mesh;
}

/// The whole ring: both cuts of a sector of 2π sewn together, their groups
/// left without faces.
template <int dim>
mesh::PartMesh<dim> ring_mesh(Annulus annulus) {
  annulus.span = 2.0 * std::numbers::pi;
  auto mesh = sector_mesh<dim>(annulus);
  // Vertices lie radius first, then angle, then z.
  const auto row = static_cast<unsigned>(annulus.radial + 1);
  const auto rows = static_cast<unsigned>(annulus.angular + 1);
  const auto sewn = [&](unsigned vertex) {
    const unsigned layer = vertex / (row * rows);
    const unsigned angle = vertex / row % rows;
    return (layer * (rows - 1) + angle % (rows - 1)) * row + vertex % row;
  };
  std::vector<typename mesh::PartMesh<dim>::Point> vertices(
      mesh.vertices.size() / rows * (rows - 1));
  for (unsigned v = static_cast<unsigned>(mesh.vertices.size()); v-- > 0;) {
    vertices[sewn(v)] = mesh.vertices[v];
  }
  mesh.vertices = vertices;
  for (auto& cell : mesh.cells) {
    for (unsigned& vertex : cell) vertex = sewn(vertex);
  }
  std::erase_if(mesh.boundary, [](const mesh::BoundaryFace& face) {
    return face.group == 2 || face.group == 3;
  });
  return mesh;
}

}  // namespace clevis::support
