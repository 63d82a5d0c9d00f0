#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "elasticity/discretization.h"
#include "elasticity/tabulation.h"
#include "loads/discrete_balance.h"

namespace clevis::elasticity {

/// Basis functions that live on a face of the reference cell, and the
/// geometry, at the face's quadrature points.
template <int dim>
struct FaceTable {
  FaceQuadrature<dim> rule;
  Tabulation geometry;
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

/// One table per local face, made on demand; outlives the traces.
template <int dim>
using FaceTables = std::map<int, FaceTable<dim>>;

/// @param tables  shared by the traces of one discretisation; outlives them.
template <int dim>
GroupTrace group_trace(const Discretization<dim>& discretization, int group,
                       FaceTables<dim>& tables);

}  // namespace clevis::elasticity
