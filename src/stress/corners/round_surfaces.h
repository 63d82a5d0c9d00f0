#pragma once

#include <set>
#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// A bore_* or round_* group of a mesh.
struct RoundSurface {
  std::set<unsigned> vertices;          ///< of the mesh
  std::vector<Eigen::Vector3d> points;  ///< on its cylinder, in L [m]
};

/// Round surfaces of a mesh. Their points stand on the cylinder, an eighth of a
/// facet apart along the edges and diagonals of each facet, so that the
/// distance of a surface does not depend on how coarsely it is meshed.
template <int dim>
std::vector<RoundSurface> round_surfaces(const mesh::PartMesh<dim>& mesh);

/// Position of a vertex in L; of a plane mesh in its mid-plane [m].
template <int dim>
Eigen::Vector3d position(const mesh::PartMesh<dim>& mesh, unsigned vertex);

}  // namespace clevis::stress
