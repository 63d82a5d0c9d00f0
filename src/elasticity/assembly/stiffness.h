#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/fe_space/tabulation.h"
#include "part/material.h"

namespace clevis::elasticity {

/// λ and μ of the model: in 3-D Lamé's, for dim = 2 those of plane stress,
/// λ* = 2λμ/(λ + 2μ) [Pa].
template <int dim>
struct LameConstants {
  double lambda{}, mu{};
};
template <int dim>
LameConstants<dim> lame_constants(const part::Material& material);

/// Symmetric stiffness matrix in blocks of dim × dim per pair of nodes; only
/// pairs with column node >= row node are kept.
template <int dim>
struct StiffnessMatrix {
  using Block = Eigen::Matrix<double, dim, dim>;
  std::vector<int> row_start;  ///< nodes + 1
  std::vector<int> column;     ///< sorted within a row
  std::vector<Block> block;    ///< [N/m]

  int nodes() const { return static_cast<int>(row_start.size()) - 1; }
  /// K x for a block of vectors, all degrees of freedom.
  Eigen::MatrixXd multiply(const Eigen::MatrixXd& x) const;
  /// |K|, entry by entry.
  StiffnessMatrix absolute() const;
};

/// Gauss rule of the stiffness: degree + 1 points a direction, one more where
/// tensor cells are curved.
template <int dim>
Quadrature<dim> stiffness_quadrature(const Discretization<dim>& discretization);

/// Whether a cell's mapping is not positive at a quadrature point of the
/// stiffness: interpolated with a low degree, a thin and strongly curved cell
/// may fold that the mesh's own geometry does not.
template <int dim>
bool folds(const Discretization<dim>& discretization);

/// @param determinant  of a cell's mapping at the points of a rule [m³], for
///   dim = 2 [m²].
/// @param degree  of the geometry, for the message.
/// @throws Error M005 unless all are positive.
void require_positive(const Eigen::VectorXd& determinant, std::size_t cell,
                      int degree, const std::string& place);

/// K = ∫ Bᵀ D B dV (times the thickness for dim = 2), stiffness_quadrature.
/// @param place  of an error, e.g. "part DCE".
/// @throws Error M005 if the mapping of a cell is not positive at a point.
template <int dim>
StiffnessMatrix<dim> assemble_stiffness(
    const Discretization<dim>& discretization, const part::Material& material,
    const std::string& place);

}  // namespace clevis::elasticity
