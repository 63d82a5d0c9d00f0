#include "elasticity/dealii/dealii_engine.h"

#include <algorithm>
#include <cmath>

#include <deal.II/base/multithread_info.h>
#include <deal.II/lac/solver_cg.h>

#include "elasticity/dealii/polynomial_multigrid.h"
#include "elasticity/engine_library/engine_library.h"
#include "elasticity/engine_library/petsc_session.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

template <int dim>
int points_a_direction(const Discretization<dim>& discretization) {
  const auto points = stiffness_quadrature(discretization).weights.size();
  return static_cast<int>(
      std::lround(std::pow(static_cast<double>(points), 1.0 / dim)));
}

template <int dim>
CellStiffness cell_stiffness(const Discretization<dim>& discretization,
                             const part::Material& material) {
  const auto lame = lame_constants<dim>(material);
  return {lame.lambda * discretization.thickness,
          lame.mu * discretization.thickness};
}

MPI_Comm start(bool is_shared) {
  start_petsc();
  dealii::MultithreadInfo::set_thread_limit(1);  // sums keep their order
  return is_shared ? MPI_COMM_WORLD : MPI_COMM_SELF;
}

/// Rows that each rank filled by itself, the others being zero.
void share_rows(MatrixXd& columns, MPI_Comm ranks) {
  if (dealii::Utilities::MPI::n_mpi_processes(ranks) == 1) return;
  for (Index column = 0; column < columns.cols(); ++column) {
    MPI_Allreduce(MPI_IN_PLACE, columns.col(column).data(),
                  static_cast<int>(columns.rows()), MPI_DOUBLE, MPI_SUM, ranks);
  }
}

template <int dim>
class MatrixFreeEngine final : public DealiiEngine {
 public:
  explicit MatrixFreeEngine(const DealiiTask<dim>& task)
      : beds_(bed_faces(task.discretization, task.bed)),
        share_(task.discretization, start(task.is_shared)),
        space_(share_, task.discretization, task.discretization.degree,
               task.held),
        number_(own_numbering(space_, task.discretization)),
        is_held_(static_cast<std::size_t>(task.discretization.dofs())),
        multigrid_({share_, task.discretization, task.held,
                    cell_stiffness(task.discretization, task.material), beds_,
                    task.place},
                   space_) {
    for (const int dof : task.held) {
      is_held_[static_cast<std::size_t>(dof)] = true;
    }
    stiffness_.reinit(space_, points_a_direction(task.discretization),
                      cell_stiffness(task.discretization, task.material),
                      beds_);
    report_.levels = static_cast<int>(multigrid_.levels());
  }

  MatrixXd solve(const MatrixXd& loads) override;
  MatrixXd multiply_absolute_diagonal(const MatrixXd& columns) const override;
  const DealiiReport& report() const override { return report_; }

 private:
  static std::vector<BedFace> bed_faces(
      const Discretization<dim>& discretization,
      const FoundationStiffness<dim>& bed);
  void take(const MatrixXd& columns, Index column, Vector& to) const;
  void give(const Vector& from, double scale, MatrixXd& columns,
            Index column) const;
  void solve_column(const Vector& load, Vector& solution);

  std::vector<BedFace> beds_;
  MeshShare<dim> share_;
  DegreeSpace<dim> space_;
  std::vector<int> number_;  // of the discretisation, per row of the rank
  std::vector<bool> is_held_;
  PolynomialMultigrid<dim> multigrid_;
  StiffnessOperator<dim, double> stiffness_;
  DealiiReport report_;
};

template <int dim>
std::vector<BedFace> MatrixFreeEngine<dim>::bed_faces(
    const Discretization<dim>& discretization,
    const FoundationStiffness<dim>& bed) {
  std::vector<BedFace> result;
  for (const auto& face : bed.faces()) {
    const auto cell = static_cast<std::size_t>(face.cell);
    const auto& nodes = discretization.cell_nodes[cell];
    const auto size = static_cast<unsigned>(face.matrix.rows());
    BedFace entry{cell, {}, dealii::FullMatrix<double>(size, size)};
    for (const int node : face.nodes) {
      entry.nodes.push_back(
          static_cast<int>(std::ranges::find(nodes, node) - nodes.begin()));
    }
    for (unsigned i = 0; i < size; ++i) {
      for (unsigned j = 0; j < size; ++j) {
        entry.matrix(i, j) = face.matrix(i, j);
      }
    }
    result.push_back(std::move(entry));
  }
  return result;
}

template <int dim>
void MatrixFreeEngine<dim>::take(const MatrixXd& columns, Index column,
                                 Vector& to) const {
  for (unsigned row = 0; row < number_.size(); ++row) {
    const int dof = number_[row];
    to.local_element(row) =
        is_held_[static_cast<std::size_t>(dof)] ? 0.0 : columns(dof, column);
  }
}

template <int dim>
void MatrixFreeEngine<dim>::give(const Vector& from, double scale,
                                 MatrixXd& columns, Index column) const {
  for (unsigned row = 0; row < number_.size(); ++row) {
    columns(number_[row], column) = scale * from.local_element(row);
  }
}

/// Sweeps of conjugate gradients on the true residual: the first to its
/// tolerance, each further one shrinks the error and tells what it was.
template <int dim>
void MatrixFreeEngine<dim>::solve_column(const Vector& load, Vector& solution) {
  constexpr int kSweeps = 6;
  constexpr int kMostIterations = 500;
  constexpr double kFirst = 1e-10;
  constexpr double kLater = 1e-3;
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
MatrixXd MatrixFreeEngine<dim>::solve(const MatrixXd& loads) {
  MatrixXd result = MatrixXd::Zero(loads.rows(), loads.cols());
  Vector load;
  Vector solution;
  stiffness_.initialize_dof_vector(load);
  stiffness_.initialize_dof_vector(solution);
  for (Index column = 0; column < loads.cols(); ++column) {
    take(loads, column, load);
    const double scale = load.l2_norm();
    if (!(scale > 0.0)) continue;
    load /= scale;
    solution = 0.0;
    solve_column(load, solution);
    give(solution, scale, result, column);
  }
  share_rows(result, share_.ranks());
  return result;
}

template <int dim>
MatrixXd MatrixFreeEngine<dim>::multiply_absolute_diagonal(
    const MatrixXd& columns) const {
  const Vector diagonal = stiffness_.diagonal();
  MatrixXd result = MatrixXd::Zero(columns.rows(), columns.cols());
  for (unsigned row = 0; row < number_.size(); ++row) {
    result.row(number_[row]) = std::abs(diagonal.local_element(row)) *
                               columns.row(number_[row]).cwiseAbs();
  }
  share_rows(result, share_.ranks());
  return result;
}

}  // namespace

CLEVIS_ENGINE_ENTRY std::unique_ptr<DealiiEngine> clevis_dealii_2(
    const DealiiTask<2>& task) {
  return std::make_unique<MatrixFreeEngine<2>>(task);
}

CLEVIS_ENGINE_ENTRY std::unique_ptr<DealiiEngine> clevis_dealii_3(
    const DealiiTask<3>& task) {
  return std::make_unique<MatrixFreeEngine<3>>(task);
}

}  // namespace clevis::elasticity
