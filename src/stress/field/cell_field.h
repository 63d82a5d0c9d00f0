#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"

namespace clevis::stress {

/// 2-D: xx, yy, xy of plane stress; 3-D: xx, yy, zz, xy, yz, xz.
template <int dim>
inline constexpr int kStressComponents = dim == 2 ? 3 : 6;

/// Squares of von Mises [Pa²], points × columns, of stress blocks as CellField
/// gives them.
/// @param n  points.
template <int dim>
Eigen::ArrayXXd von_mises_squared(const Eigen::MatrixXd& stress,
                                  Eigen::Index n);

/// What von Mises is the norm of: of a deviator that has five components in 3-D
/// and three in 2-D, the sum of whose squares is its square. Linear in stress,
/// and fewer components to combine.
template <int dim>
inline constexpr int kDeviatorComponents = dim == 2 ? 3 : 5;

/// Blocks of `n` rows, one per component [Pa].
/// @param stress  blocks as CellField gives them.
template <int dim>
Eigen::MatrixXd deviator(const Eigen::MatrixXd& stress, Eigen::Index n);

/// Stress and displacement at the same reference points of any cell, for many
/// displacement vectors at once.
template <int dim>
class CellField {
 public:
  /// @param discretization  outlives the object.
  /// @param points  dim × points in reference coordinates.
  CellField(const elasticity::Discretization<dim>& discretization,
            const part::Material& material,
            const elasticity::ReferencePoints<dim>& points);

  /// Stress [Pa] of displacement vectors (dofs × columns): blocks of `points`
  /// rows, one per component.
  Eigen::MatrixXd stress(std::size_t cell,
                         const Eigen::MatrixXd& columns) const;

  /// Displacement [m]: points × (dim × columns), component after component.
  Eigen::MatrixXd displacement(std::size_t cell,
                               const Eigen::MatrixXd& columns) const;

  /// Positions [m]: points × dim.
  Eigen::MatrixXd positions(std::size_t cell) const;

 private:
  Eigen::MatrixXd nodal_values(std::size_t cell,
                               const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd gradients(std::size_t cell,
                            const Eigen::MatrixXd& columns) const;

  const elasticity::Discretization<dim>& discretization_;
  elasticity::LameConstants<dim> lame_;
  std::vector<int> places_;  ///< of a cell's nodes among those interpolated
  elasticity::CellInterpolation<dim> displacement_, geometry_;
  /// A millionth of a cell inside its edges, where slopes of revolved cells are
  /// taken that touch their axis: on it their directions coincide.
  elasticity::CellInterpolation<dim> displacement_beside_, geometry_beside_;
};

}  // namespace clevis::stress
