#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/fe_space/tabulation.h"
#include "loads/pressure/discrete_balance.h"

namespace clevis::elasticity {

/// Basis functions that live on a face of the reference cell, and the
/// geometry, at the face's quadrature points.
template <int dim>
struct FaceTable {
  FaceQuadrature<dim> rule;
  CellInterpolation<dim> geometry;
  std::vector<std::size_t> functions;
  Eigen::MatrixXd values;  ///< points × functions
};

/// Quadrature of a group's faces with the trace of the basis, in 3-D.
struct GroupTrace {
  loads::GroupQuadrature quadrature;
  Eigen::Matrix3Xd outward;  ///< unit normals
  struct Face {
    std::vector<int> nodes;
    const Eigen::MatrixXd* values;  ///< points × nodes
  };
  std::vector<Face> faces;
};

/// Whether a surface group of the part has faces on this mesh.
template <int dim>
bool has_faces(const Discretization<dim>& discretization,
               const std::string& group);

/// One table per local face, made on demand; outlives the traces.
template <int dim>
using FaceTables = std::map<int, FaceTable<dim>>;

/// The table of a whole local face, made if it is missing.
template <int dim>
const FaceTable<dim>& whole_face_table(
    const Discretization<dim>& discretization, int face,
    FaceTables<dim>& tables);

/// Some faces' quadrature points [m] and area vectors, outward, times weights
/// [m²].
struct WeightedSurface {
  Eigen::Matrix3Xd points, areas;
};
template <int dim>
WeightedSurface weighted_surface(const Discretization<dim>& discretization,
                                 int cell, const FaceTable<dim>& table);

/// Collects faces.
template <int dim>
class TraceBuilder {
 public:
  explicit TraceBuilder(const Discretization<dim>& discretization)
      : discretization_(discretization) {}
  /// @param functions  of the cell that live on the face.
  /// @param values     points × functions [1]; outlive the trace.
  void add(int cell, const std::vector<std::size_t>& functions,
           const Eigen::MatrixXd& values, const WeightedSurface& surface);
  GroupTrace finish();

 private:
  const Discretization<dim>& discretization_;
  std::vector<GroupTrace::Face> faces_;
  std::vector<Eigen::Vector3d> points_, areas_;
};

/// @param tables  shared by the traces of one discretisation; outlives them.
template <int dim>
GroupTrace group_trace(const Discretization<dim>& discretization, int group,
                       FaceTables<dim>& tables);

}  // namespace clevis::elasticity
