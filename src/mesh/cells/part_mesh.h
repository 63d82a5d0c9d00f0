#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "part/bore.h"

namespace clevis::mesh {

enum class CellShape { kTensor, kSimplex };  // quad/hex, triangle/tetrahedron

/// A face of a cell on the outer boundary.
///
/// Local face numbers of tensor cells: 2*d + (0 at ξ_d = 0, 1 at ξ_d = 1), as
/// in deal.II. Of simplices: deal.II's ReferenceCells numbering.
struct BoundaryFace {
  int cell{};
  int face{};
  int group = -1;  ///< index into PartMesh::groups; -1: unnamed surface
};

/// A named piece of the surface (a gmsh physical group).
struct SurfaceGroup {
  std::string name;
  /// Set for bore_* and round_*: the nodes of the faces lie on it exactly.
  std::optional<part::Bore> cylinder;
};

/// Mesh of one part with its exact geometry, SI, in the part's frame L.
///
/// Each cell carries its own geometry points: the Lagrange points of a
/// mapping of degree `degree` on Gauss–Lobatto points in lexicographic order
/// (ξ_0 fastest), dim-dimensional; of simplices on the points and in the order
/// of simplex_nodes. Neighbouring cells hold the same points on a shared face.
/// For dim = 2 the mesh is the mid-plane of a plate of constant thickness
/// that is loaded in its plane; frame L's z is normal to it.
template <int dim>
struct PartMesh {
  using Point = Eigen::Matrix<double, dim, 1>;

  CellShape shape = CellShape::kTensor;
  int degree = 1;
  std::vector<Point> vertices;  ///< corner nodes [m]
  /// Vertex indices per cell, lexicographic (deal.II order) for tensor cells.
  std::vector<std::vector<unsigned>> cells;
  /// Per cell, dim × (degree+1)^dim, of simplices fewer [m].
  std::vector<Eigen::Matrix<double, dim, Eigen::Dynamic>> cell_points;
  std::vector<BoundaryFace> boundary;
  std::vector<SurfaceGroup> groups;
  std::vector<std::string> empty_groups;  ///< named in the file, without a face
  double thickness{};                     ///< dim = 2: [m]
  double mid_plane_z{};  ///< dim = 2: z of the mid-plane in L [m]
};

}  // namespace clevis::mesh
