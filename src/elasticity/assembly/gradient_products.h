#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// Products of gradients ∫ ∂_a N_i ∂_b N_j dV of a cell's functions for a <= b:
/// all that an isotropic element matrix is made of.
template <int dim>
class GradientProducts {
 public:
  /// @return of ∂_a N_i and ∂_b N_j, whichever is larger of a and b [m].
  double operator()(std::size_t a, std::size_t b, Eigen::Index i,
                    Eigen::Index j) const {
    return a <= b ? values_[a][b](row_[i] + column_[j])
                  : values_[b][a](row_[j] + column_[i]);
  }

 private:
  template <int>
  friend class GradientIntegrator;

  std::array<std::array<Eigen::VectorXd, dim>, dim> values_;
  /// The product of i and j stands at row_[i] + column_[j].
  Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 1> row_, column_;
};

/// Integrates them cell after cell. Of hexahedra of degree 3 and more direction
/// after direction: a tenth of the operations at degree 6.
template <int dim>
class GradientIntegrator {
 public:
  /// @param rule  of tensor cells a product of rules of one direction.
  GradientIntegrator(const Discretization<dim>& discretization,
                     const Quadrature<dim>& rule);

  /// @param cell  at the points of the rule.
  /// @param weights  of these, with the determinant [m³], for dim = 2 with the
  ///   thickness.
  /// @return until the next call.
  const GradientProducts<dim>& integrate(const CellGeometry<dim>& cell,
                                         const Eigen::VectorXd& weights);

 private:
  void by_points(const CellGeometry<dim>& cell, const Eigen::VectorXd& weights);
  void by_directions(const CellGeometry<dim>& cell,
                     const Eigen::VectorXd& weights);
  void set_up_directions(const Discretization<dim>& discretization,
                         const Quadrature<dim>& rule);

  /// Products of a direction's functions N_i and N_j at its points: points ×
  /// pairs, i first; by [derivative of N_i][derivative of N_j].
  using Line = std::array<std::array<Eigen::MatrixXd, 2>, 2>;

  Tabulation displacement_;
  bool is_by_directions_ = false;
  std::array<Line, dim> lines_;
  /// Of the last direction one below the other, [0][0], [0][1], [1][0], [1][1].
  Eigen::MatrixXd last_line_;
  GradientProducts<dim> products_;
};

}  // namespace clevis::elasticity
