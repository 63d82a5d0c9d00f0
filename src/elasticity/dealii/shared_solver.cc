#include "elasticity/dealii/shared_solver.h"

#include <algorithm>

#include <deal.II/lac/solver_cg.h>

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
SharedSolver<dim>::SharedSolver(const DealiiTask<dim>* task, MPI_Comm ranks)
    : ranks_(ranks),
      part_(dealii::Utilities::MPI::broadcast(
          ranks, task != nullptr ? engine_part(*task) : EnginePart{})),
      share_(task, part_, ranks),
      space_(share_, part_.degree),
      multigrid_(part_, space_) {
  stiffness_.reinit(space_, part_.gauss_points, part_.stiffness, part_.beds);
  report_.levels = static_cast<int>(multigrid_.levels());
  report_.bytes_sent = dealii::Utilities::MPI::sum(
      static_cast<double>(stiffness_.bytes_sent()), ranks);
  take_rows(task);
}

template <int dim>
void SharedSolver<dim>::take_rows(const DealiiTask<dim>* task) {
  const std::vector<int> mine = own_numbering(space_);
  const auto all = dealii::Utilities::MPI::gather(ranks_, mine);
  if (task == nullptr) return;
  for (const auto& rows : all) {
    counts_.push_back(static_cast<int>(rows.size()));
    starts_.push_back(static_cast<int>(rows_.size()));
    rows_.insert(rows_.end(), rows.begin(), rows.end());
  }
  is_held_ = held_marks(*task);
}

/// @param column  on the first rank.
template <int dim>
void SharedSolver<dim>::scatter(const double* column, Vector& to) const {
  std::vector<double> values(rows_.size());
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const int dof = rows_[r];
    values[r] =
        is_held_[static_cast<std::size_t>(dof)] != 0 ? 0.0 : column[dof];
  }
  MPI_Scatterv(values.data(), counts_.data(), starts_.data(), MPI_DOUBLE,
               to.get_values(), static_cast<int>(to.locally_owned_size()),
               MPI_DOUBLE, 0, ranks_);
}

/// @param column  on the first rank.
template <int dim>
void SharedSolver<dim>::gather(const Vector& from, double* column) const {
  std::vector<double> values(rows_.size());
  MPI_Gatherv(from.get_values(), static_cast<int>(from.locally_owned_size()),
              MPI_DOUBLE, values.data(), counts_.data(), starts_.data(),
              MPI_DOUBLE, 0, ranks_);
  for (std::size_t r = 0; r < rows_.size(); ++r) column[rows_[r]] = values[r];
}

/// Sweeps of conjugate gradients on the true residual: the first to its
/// tolerance, each further one shrinks the error and tells what it was.
template <int dim>
void SharedSolver<dim>::solve_column(const Vector& load, Vector& solution) {
  constexpr int kSweeps = 6;
  constexpr int kMostIterations = 500;
  constexpr double kFirst = 1e-9;
  constexpr double kLater = 0.1;  // enough to tell what the first one left
  constexpr double kWanted = 1e-11;
  Vector residual(load);
  Vector step;
  Vector product;
  stiffness_.initialize_dof_vector(step);
  stiffness_.initialize_dof_vector(product);
  int iterations = 0;
  double correction = 1.0;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    dealii::IterationNumberControl control(
        kMostIterations, (sweep == 0 ? kFirst : kLater) * residual.l2_norm());
    dealii::SolverFlexibleCG<Vector> cg(control);
    step = 0.0;
    cg.solve(stiffness_, step, residual, multigrid_);
    iterations += static_cast<int>(control.last_step());
    solution += step;
    const double size = solution.l2_norm();
    correction = size > 0.0 ? step.l2_norm() / size : 0.0;
    stiffness_.vmult(product, solution);
    residual = load;
    residual -= product;
    if (sweep > 0 && correction * kLater < kWanted) break;
  }
  report_.iterations = std::max(report_.iterations, iterations);
  report_.correction = std::max(report_.correction, correction * kLater);
}

template <int dim>
void SharedSolver<dim>::solve(Index columns, const MatrixXd& loads,
                              MatrixXd& result) {
  const bool is_first = result.cols() > 0;
  Vector load;
  Vector solution;
  stiffness_.initialize_dof_vector(load);
  stiffness_.initialize_dof_vector(solution);
  for (Index column = 0; column < columns; ++column) {
    scatter(is_first ? loads.col(column).data() : nullptr, load);
    const double scale = load.l2_norm();
    if (!(scale > 0.0)) continue;
    load /= scale;
    solution = 0.0;
    solve_column(load, solution);
    solution *= scale;
    gather(solution, is_first ? result.col(column).data() : nullptr);
  }
}

template <int dim>
Eigen::VectorXd SharedSolver<dim>::diagonal() const {
  Eigen::VectorXd result(static_cast<Index>(is_held_.size()));
  gather(stiffness_.diagonal(), result.data());
  return result;
}

template class SharedSolver<2>;
template class SharedSolver<3>;

}  // namespace clevis::elasticity
