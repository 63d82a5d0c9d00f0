#pragma once

#include "elasticity/dealii/dealii_engine.h"

namespace clevis::elasticity {

/// Whether the deal.II engine can take a part: tensor cells of one degree in
/// all directions.
template <int dim>
bool suits_dealii(const Discretization<dim>& discretization);

/// @param place  of the error, e.g. "part DCE".
/// @throws Error F005 unless suits_dealii().
template <int dim>
void require_suits_dealii(const Discretization<dim>& discretization,
                          const std::string& place);

/// K U = F by deal.II: matrix-free stiffness on the exact geometry, conjugate
/// gradients, a column after the other, multigrid over falling degrees, its
/// coarsest level by PETSc. The same code for one process and for all ranks of
/// MPI: the first one has the part and its solution, levels, vectors and work
/// are shared with those that serve_dealii().
template <int dim>
class DealiiSolver {
 public:
  /// @param bed   in the numbering of the discretisation.
  /// @param held  degrees of freedom of the discretisation that are zero.
  /// @param is_shared  with the other ranks of this MPI run.
  /// @param most_factored  equations of the coarsest level that are factored;
  ///   more are left to algebraic multigrid.
  /// @pre suits_dealii().
  /// @throws Error F002 from the coarsest level.
  DealiiSolver(const Discretization<dim>& discretization,
               const part::Material& material,
               const FoundationStiffness<dim>& bed,
               const std::vector<int>& held, const std::string& place,
               bool is_shared = false, double most_factored = kMostFactored);
  ~DealiiSolver();
  DealiiSolver(const DealiiSolver&) = delete;
  DealiiSolver& operator=(const DealiiSolver&) = delete;

  /// dofs × columns; held rows of the loads don't matter, of the result are
  /// zero.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& loads);

  /// |diagonal of K| |u|: at most |K| |u|.
  Eigen::MatrixXd multiply_absolute_diagonal(
      const Eigen::MatrixXd& columns) const;

  const DealiiReport& report() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace clevis::elasticity
