#pragma once

#include <array>
#include <vector>

#include "mesh/cells/part_mesh.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {

/// Surface of a field's lattice, for pictures. Each cell keeps its own points:
/// stresses jump between cells, and a mean would hide the peak.
struct SurfaceMesh {
  std::vector<FieldPoint> points;
  /// Positions in `points`, outward, those of a cell together; of dim = 2 the
  /// mid-plane, up its z.
  std::vector<std::array<int, 3>> triangles;
  /// Of dim = 2 the edges of the outline, counterclockwise about z; else none.
  std::vector<std::array<int, 2>> outline;
};

/// Cells follow one another so that neighbours stand near in the list.
/// @param field  of a mesh of `shape` cells; faces whose lattice points
///   coincide to 1e-7 of its size are inner ones.
template <int dim>
SurfaceMesh surface_mesh(mesh::CellShape shape, const InstantField& field);

/// Points of which some are the same.
struct SharedPoints {
  std::vector<int> number;  ///< of each point, among those that stay
  std::vector<int> kept;    ///< the first of those that are the same
};

/// Makes points one that stand at the same place, to 1e-7 of the size of all,
/// and whose values agree at all instants: cells that meet without a jump.
/// @param positions  points × 3 [m].
/// @param values  points × instants; without instants the place alone counts.
/// @param tolerance  of the values, their unit.
SharedPoints share_points(const Eigen::MatrixX3d& positions,
                          const Eigen::MatrixXd& values, double tolerance);

/// Point of a coarser lattice of a cell that may stand in for one of a finer:
/// the nearest on the same corner, edge or face of the cell, or inside it; on
/// the border of that where it has no other.
template <int dim>
int stand_in(mesh::CellShape shape, int fine, int fine_point, int coarse);

}  // namespace clevis::stress
