#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Where the cylinders of the groups touch the mesh.
struct CylindricalEntities {
  using Edge = std::pair<unsigned, unsigned>;  ///< lower vertex first
  std::map<unsigned, std::set<int>> vertices;  ///< groups of each
  std::map<Edge, std::set<int>> edges;
  std::map<std::pair<int, int>, int> faces;  ///< by cell and local face

  bool touch(const std::vector<unsigned>& cell) const;
};

CylindricalEntities find_cylindrical_entities(const PartMesh<3>& mesh);

/// Nearest point to p [m] that lies on the cylinders of all the given groups.
Eigen::Vector3d project_on_all(const PartMesh<3>& mesh,
                               const std::set<int>& groups, Eigen::Vector3d p);

/// Points at t of [0, 1] along an edge on cylinders, from one vertex to the
/// other: with equal angles, which converges fastest; a curved edge of the
/// file that is clearly another curve (an oblique cut, say) keeps its own.
/// @param straight    the edge's points, moved with its ends only.
/// @param file_order  of the geometry in the file.
std::vector<Eigen::Vector3d> round_edge(
    const PartMesh<3>& mesh, const std::set<int>& groups, unsigned from,
    unsigned to, const std::vector<double>& t,
    const std::vector<Eigen::Vector3d>& straight, int file_order);

}  // namespace clevis::mesh
