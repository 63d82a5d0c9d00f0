#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/mass_matrix.h"
#include "elasticity/assembly/node_pairs.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/fe_space/discretization.h"
#include "part/material.h"

namespace clevis::elasticity {

/// Stresses σ_k of displacement columns as what they add to the stiffness of a
/// body that moves on from them: the geometric stiffness ∫ ∇N_i·σ ∇N_j dV, the
/// same for every component of the displacement. Integrated like the stiffness.
///
/// Source: [ZienkiewiczTaylor] 5 (initial stress matrix); docs/theory.md,
/// "Linear buckling".
class InitialStress {
 public:
  /// @param discretization  outlives the object.
  /// @param columns  displacements, dofs × columns [m].
  InitialStress(const Discretization<3>& discretization,
                const part::Material& material, Eigen::MatrixXd columns);

  /// Of Σ c_k σ_k [N/m].
  MassMatrix stiffness(const NodePairs& pattern,
                       const Eigen::VectorXd& coefficients) const;
  /// Of 1 Pa in all directions: ∫ ∇N_i·∇N_j dV [m].
  MassMatrix unit_stiffness(const NodePairs& pattern) const;
  /// ∫ ρ N_i N_j dV [kg]. @param density  [kg/m³].
  MassMatrix mass(const NodePairs& pattern, double density) const;

  /// v_aᵀ K_G(σ_k) v_b: a row for each pair a <= b (0 0, 0 1, 1 1, 0 2, …), a
  /// column for each k [N m].
  /// @param first  of the vectors b: pairs of those before are left out.
  Eigen::MatrixXd forms(const NodePairs& pattern,
                        const Eigen::MatrixXd& vectors,
                        Eigen::Index first) const;

 private:
  struct Cell {
    CellGeometry<3> geometry;
    Eigen::VectorXd weights;
  };
  Cell cell(std::size_t c) const;
  Eigen::MatrixXd slopes(const Cell& cell, std::size_t c,
                         const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd stress(const Cell& cell, std::size_t c,
                         const Eigen::MatrixXd& columns) const;

  const Discretization<3>& discretization_;
  LameConstants<3> lame_;
  Eigen::MatrixXd columns_;
  Quadrature<3> rule_;
  std::vector<int> places_;  ///< of a cell's nodes among those interpolated
  CellInterpolation<3> displacement_, geometry_;
  Tabulation functions_;  ///< of the displacement
};

/// A matrix of the nodes times displacements (dofs × columns), component by
/// component.
Eigen::MatrixXd multiply(const MassMatrix& matrix,
                         const Eigen::MatrixXd& displacements);

}  // namespace clevis::elasticity
