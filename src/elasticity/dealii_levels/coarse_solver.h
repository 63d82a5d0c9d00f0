#pragma once

#include <memory>
#include <string>

#include "elasticity/dealii_levels/stiffness_operator.h"

namespace clevis::elasticity {

/// How the coarsest level is solved.
enum class CoarseMethod {
  kFactor,    ///< MUMPS' Cholesky
  kMultigrid  ///< GAMG, told the rigid modes
};

/// The stiffness of one degree, assembled and solved by PETSc over all ranks.
template <int dim>
class CoarseSolver {
 public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<float>;

  /// @param stiffness  on `space`.
  /// @param name  entity for messages ("part DCE").
  /// @throws Error F002 if the matrix is not positive definite.
  CoarseSolver(const DegreeSpace<dim>& space,
               const StiffnessOperator<dim, double>& stiffness,
               CoarseMethod method, const std::string& name);
  ~CoarseSolver();
  CoarseSolver(const CoarseSolver&) = delete;
  CoarseSolver& operator=(const CoarseSolver&) = delete;

  /// x ≈ K⁻¹ b.
  void solve(Vector& x, const Vector& b) const;

 private:
  struct Petsc;
  std::unique_ptr<Petsc> petsc_;
};

}  // namespace clevis::elasticity
