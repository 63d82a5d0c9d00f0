#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// Edges are looked at at this many points and one more, evenly.
constexpr int kEdgeIntervals = 4;

using EdgePoints = Eigen::Matrix<double, 3, kEdgeIntervals + 1>;

/// A face of the boundary at one of its edges, at the edge's points.
struct EdgeSide {
  int face{};         ///< number in PartMesh::boundary
  EdgePoints points;  ///< in the cell's reference coordinates
  EdgePoints normal;  ///< of the face, outward, unit
  EdgePoints along;   ///< of the edge, unit
  double length{};    ///< of the edge [m]
};

/// An edge between two faces of the boundary where the part is smooth.
struct SurfaceEdge {
  EdgeSide one, other;
  /// Angle between the normals at its points [rad].
  Eigen::Array<double, kEdgeIntervals + 1, 1> kink;
};

/// Edges of the boundary whose faces meet below 20° everywhere; others are
/// edges of the part.
/// @param wanted  per vertex of the mesh: edges with both ends are looked at.
std::vector<SurfaceEdge> smooth_edges(const mesh::PartMesh<3>& mesh,
                                      const std::vector<char>& wanted);

}  // namespace clevis::stress
