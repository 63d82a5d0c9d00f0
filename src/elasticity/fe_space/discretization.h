#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/cell_interpolation.h"
#include "elasticity/fe_space/tabulation.h"
#include "mesh/cells/part_mesh.h"

namespace clevis::elasticity {

/// A face of the boundary in the discretisation's own cell orientation.
struct GroupFace {
  int cell{};
  int face{};
};

/// A part's mesh with the degrees of freedom of the continuous Lagrange element
/// of one degree, as plain data: nothing of deal.II passes this border.
///
/// Degrees of freedom are scalar "nodes"; component d of the displacement at
/// node i is number dim*i + d. Cells are oriented as deal.II numbers them, so
/// `cell_points` may be permuted against PartMesh. The geometry is the mesh's,
/// interpolated with the displacement's degree where that is lower: only then
/// are rigid rotations and uniform strains exactly in the space.
template <int dim>
struct Discretization {
  mesh::CellShape shape{};
  int degree{};
  int geometry_degree{};
  /// dim = 3: one layer of cells whose third reference direction is a plate's
  /// z, with degrees of their own in it; else these equal the two above.
  bool is_layer = false;
  int thickness_degree{};
  int geometry_thickness_degree{};
  /// dim = 3: a meridian turned round an axis; the third reference direction
  /// runs round it. On the axis cells have an edge of no length.
  bool is_revolved = false;
  int nodes{};  ///< scalar degrees of freedom
  std::vector<std::vector<int>> cell_nodes;
  std::vector<Eigen::Matrix<double, dim, Eigen::Dynamic>> cell_points;
  std::vector<std::vector<GroupFace>> group_faces;  ///< per group of the mesh
  std::vector<mesh::SurfaceGroup> groups;
  std::vector<int> vertex_nodes;  ///< node at each vertex of the mesh
  std::vector<Eigen::Matrix<double, dim, 1>> vertices;
  double thickness = 1.0;    ///< dim = 2: of the plate [m]
  double mid_plane_z = 0.0;  ///< dim = 2 [m]

  Degree displacement_degree() const { return {degree, thickness_degree}; }
  Degree mapping_degree() const {
    return {geometry_degree, geometry_thickness_degree};
  }
  int dofs() const { return dim * nodes; }
  int cells() const { return static_cast<int>(cell_nodes.size()); }
};

/// @param degree  1…4.
template <int dim>
Discretization<dim> discretize(const mesh::PartMesh<dim>& mesh, int degree);

/// Nodes on the faces of a group, sorted.
template <int dim>
std::vector<int> group_nodes(const Discretization<dim>& discretization,
                             int group);

/// Jacobian data of one cell at fixed points.
template <int dim>
struct CellGeometry {
  Eigen::Matrix<double, dim, Eigen::Dynamic> points;  ///< physical [m]
  std::vector<Eigen::Matrix<double, dim, dim>> inverse_jacobian;
  Eigen::VectorXd determinant;
};
/// @param cell_points  dim × points of the geometry basis [m].
template <int dim>
CellGeometry<dim> cell_geometry(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& cell_points,
    const CellInterpolation<dim>& geometry);

/// Derivatives of columns by place [1/m] from those by reference coordinates:
/// (dim·points) × columns, direction below direction.
template <int dim>
Eigen::MatrixXd physical_slopes(const CellGeometry<dim>& geometry,
                                const Eigen::MatrixXd& reference);

/// Physical gradients of the displacement basis: per direction, points ×
/// functions [1/m].
template <int dim>
std::vector<Eigen::MatrixXd> physical_gradients(
    const CellGeometry<dim>& geometry, const Tabulation& displacement);

}  // namespace clevis::elasticity
