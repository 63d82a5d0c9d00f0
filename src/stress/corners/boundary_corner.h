#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// A side of the material at a boundary corner.
struct CornerSide {
  Eigen::Vector3d direction;  ///< unit, along the surface away from the corner
  int group = -1;             ///< of its face; -1: unnamed
  double extent{};            ///< of its face, across the edge [m]
  /// Of its face's tangent from the corner to its far end, across the edge,
  /// positive where the face is hollow [rad].
  double turn{};
};

/// A boundary vertex of a plane mesh or a surface edge of a solid one, seen
/// along `axis`: the material reaches counter-clockwise from sides[0] to
/// sides[1].
struct BoundaryCorner {
  std::array<unsigned, 2> vertices{};  ///< ends of the edge; twice the vertex
  Eigen::Vector3d at;                  ///< vertex or middle of the edge, L [m]
  Eigen::Vector3d axis;                ///< unit; z for dim = 2
  std::array<CornerSide, 2> sides;
  double angle{};  ///< of the material, from its cells' true tangents [rad]
  /// Farthest vertex of the cells at the corner, across the axis [m].
  double reach{};

  Eigen::Vector3d bisector() const;  ///< unit, into the material
};

/// Of a point from a straight edge, which may be a point itself [m].
double distance_from_edge(const Eigen::Vector3d& point,
                          const Eigen::Vector3d& from,
                          const Eigen::Vector3d& to);

/// All of them where exactly two boundary faces meet, in the order of their
/// vertices.
template <int dim>
std::vector<BoundaryCorner> boundary_corners(const mesh::PartMesh<dim>& mesh);

}  // namespace clevis::stress
