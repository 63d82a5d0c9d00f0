#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "support/structured_mesh.h"

namespace clevis::support {

/// Meshes joined at vertices that stand at the same place. Groups are left
/// out, and boundary faces: faces between the meshes are inside.
inline mesh::PartMesh<3> weld(const std::vector<mesh::PartMesh<3>>& pieces) {
  mesh::PartMesh<3> whole;
  whole.degree = pieces.front().degree;
  std::map<std::array<long, 3>, unsigned> known;
  for (const auto& piece : pieces) {
    std::vector<unsigned> number;
    for (const auto& vertex : piece.vertices) {
      std::array<long, 3> key{};
      for (std::size_t d = 0; d < 3; ++d) {
        key[d] = std::lround(vertex[static_cast<Eigen::Index>(d)] * 1e9);
      }
      const auto [at, is_new] =
          known.try_emplace(key, static_cast<unsigned>(whole.vertices.size()));
      if (is_new) whole.vertices.push_back(vertex);
      number.push_back(at->second);
    }
    for (const auto& cell : piece.cells) {
      std::vector<unsigned> ids;
      for (const unsigned vertex : cell) ids.push_back(number[vertex]);
      whole.cells.push_back(ids);
    }
    whole.cell_points.insert(whole.cell_points.end(), piece.cell_points.begin(),
                             piece.cell_points.end());
  }
  return whole;
}

/// Solid round bar along z from 0: a square in the middle, four blocks round
/// it.
inline mesh::PartMesh<3> round_bar(double radius, double length, int across,
                                   int along, int degree) {
  using Eigen::Vector3d;
  const double core = 0.45 * radius;
  std::vector<mesh::PartMesh<3>> pieces;
  pieces.push_back(structured_mesh<3>(
      {across, across, along}, degree, [=](const Vector3d& x) -> Vector3d {
        return {core * (2 * x[0] - 1), core * (2 * x[1] - 1), length * x[2]};
      }));
  for (int side = 0; side < 4; ++side) {
    pieces.push_back(structured_mesh<3>(
        {1, across, along}, degree, [=](const Vector3d& x) -> Vector3d {
          const double turn = side * std::numbers::pi / 2;
          const double angle = (x[1] - 0.5) * std::numbers::pi / 2;
          const double px = (1 - x[0]) * core + x[0] * radius * std::cos(angle);
          const double py = (1 - x[0]) * core * (2 * x[1] - 1) +
                            x[0] * radius * std::sin(angle);
          return {px * std::cos(turn) - py * std::sin(turn),
                  px * std::sin(turn) + py * std::cos(turn), length * x[2]};
        }));
  }
  return weld(pieces);
}

}  // namespace clevis::support
