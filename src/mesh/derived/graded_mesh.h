#pragma once

#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Each new ring of cells around a vertex reaches to this share of the one
/// before: near the optimum of hp-elements at a singularity ([BabuskaGui1986]).
inline constexpr double kGradingRatio = 0.15;

/// A mesh with rings of cells that shrink geometrically towards vertices.
struct GradedMesh {
  PartMesh<2> mesh;
  /// Per cell: index into `vertices` of the vertex it was made for, else −1.
  std::vector<int> vertex_of;
  /// Per cell: ring around that vertex, 0 outermost; the cells at the vertex
  /// itself carry `layers`. −1: not made here.
  std::vector<int> ring;
  std::vector<unsigned> vertices;  ///< in the new mesh
};

/// Splits the quadrilaterals at each given vertex `layers` times into three:
/// one at the vertex, kGradingRatio as large, and two around it. Faces towards
/// other cells stay whole, so the mesh conforms. If a cell has two of the
/// vertices, all cells are first halved in both directions. New cells take
/// their geometry points from the mapping of the old: their shape is the old's.
/// @pre quadrilaterals.
GradedMesh grade_at_vertices(PartMesh<2> mesh, std::vector<unsigned> vertices,
                             int layers);

/// Every quadrilateral halved in both directions.
PartMesh<2> halve_cells(const PartMesh<2>& mesh);

}  // namespace clevis::mesh
