#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/dealii_levels/polynomial_multigrid.h"

namespace clevis::elasticity {

/// K U = F on the ranks that share a part. All of them make one and call its
/// functions alike; loads and solutions are the first rank's.
template <int dim>
class SharedSolver {
 public:
  /// @param task  the part on the first rank, elsewhere nothing.
  /// @throws Error F002 from the coarsest level, on all ranks.
  SharedSolver(const DealiiTask<dim>* task, MPI_Comm ranks);

  /// @param columns  as many on all ranks.
  /// @param loads   dofs × columns on the first rank, elsewhere empty [N].
  /// @param result  likewise, zero at first; held rows stay so [m].
  void solve(Eigen::Index columns, const Eigen::MatrixXd& loads,
             Eigen::MatrixXd& result);

  /// Diagonal of K on the first rank, one in held rows [N/m].
  Eigen::VectorXd diagonal() const;

  const DealiiReport& report() const { return report_; }

 private:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  void take_rows(const DealiiTask<dim>* task);
  void scatter(const double* column, Vector& to) const;
  void gather(const Vector& from, double* column) const;
  void solve_column(const Vector& load, Vector& solution);

  MPI_Comm ranks_;
  EnginePart part_;
  MeshShare<dim> share_;
  DegreeSpace<dim> space_;
  PolynomialMultigrid<dim> multigrid_;
  StiffnessOperator<dim, double> stiffness_;
  DealiiReport report_;
  // On the first rank: rows of the discretisation, rank after rank, and where
  // those of each rank begin.
  std::vector<int> rows_;
  std::vector<int> counts_, starts_;
  std::vector<char> is_held_;
};

}  // namespace clevis::elasticity
