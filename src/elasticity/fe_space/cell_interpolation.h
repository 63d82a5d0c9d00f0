#pragma once

#include <array>

#include <Eigen/Core>

#include "elasticity/fe_space/reference_cell.h"
#include "mesh/cells/part_mesh.h"

namespace clevis::elasticity {

/// Polynomials on a cell, by their values at nodes, at fixed reference points.
/// Where the points are a tensor grid of a tensor cell (lattices, Gauss
/// points), by one small matrix product per direction: some ten times fewer
/// operations than with a table of all functions at all points.
template <int dim>
class CellInterpolation {
 public:
  CellInterpolation() = default;  ///< no points
  /// Nodes are those of tabulate_geometry's basis, in its order.
  /// @param points  in reference coordinates.
  CellInterpolation(mesh::CellShape shape, Degree degree,
                    const ReferencePoints<dim>& points);

  Eigen::Index points() const { return points_; }

  /// @param nodal  nodes × columns.
  /// @return points × columns.
  Eigen::MatrixXd values(const Eigen::MatrixXd& nodal) const;

  /// Derivatives by each reference coordinate.
  /// @param nodal  nodes × columns.
  /// @return (dim·points) × columns, direction below direction.
  Eigen::MatrixXd gradients(const Eigen::MatrixXd& nodal) const;

 private:
  Eigen::Index points_ = 0;
  bool is_grid_ = false;
  /// On a grid: 1-D polynomials of each direction at its coordinates.
  std::array<Eigen::MatrixXd, dim> value_, slope_;
  /// Elsewhere: functions at points, `slopes` direction below direction.
  Eigen::MatrixXd values_, slopes_;
};

}  // namespace clevis::elasticity
