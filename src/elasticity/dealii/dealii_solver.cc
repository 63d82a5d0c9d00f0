#include "elasticity/dealii/dealii_solver.h"

#include <algorithm>
#include <cmath>

#include <deal.II/base/multithread_info.h>
#include <deal.II/lac/solver_cg.h>

#include "base/errors.h"
#include "elasticity/algebra/petsc_session.h"
#include "elasticity/dealii/polynomial_multigrid.h"

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

}  // namespace

template <int dim>
bool suits_dealii(const Discretization<dim>& discretization) {
  return discretization.shape == mesh::CellShape::kTensor &&
         !discretization.is_layer && !discretization.is_revolved &&
         discretization.thickness_degree == discretization.degree;
}

template <int dim>
void require_suits_dealii(const Discretization<dim>& discretization,
                          const std::string& place) {
  if (suits_dealii(discretization)) return;
  throw Error("F005", place,
              "the deal.II engine takes quadrangles and hexahedra only: its "
              "simplices end at straight sides and know no multigrid",
              "Leave --engine out, or mesh the part with hexahedra.");
}

template <int dim>
struct DealiiSolver<dim>::Data {
  Data(const Discretization<dim>& discretization,
       const part::Material& material, const FoundationStiffness<dim>& bed,
       const std::vector<int>& held, const std::string& place, bool is_shared)
      : beds(bed_faces(discretization, bed)),
        share(discretization, start(is_shared)),
        space(share, discretization, discretization.degree, held),
        number(own_numbering(space, discretization)),
        is_held(static_cast<std::size_t>(discretization.dofs())),
        multigrid({share, discretization, held,
                   cell_stiffness(discretization, material), beds, place},
                  space) {
    for (const int dof : held) is_held[static_cast<std::size_t>(dof)] = true;
    stiffness.reinit(space, points_a_direction(discretization),
                     cell_stiffness(discretization, material), beds);
  }

  static std::vector<BedFace> bed_faces(
      const Discretization<dim>& discretization,
      const FoundationStiffness<dim>& bed);
  void take(const MatrixXd& columns, Index column, Vector& to) const;
  void give(const Vector& from, double scale, MatrixXd& columns,
            Index column) const;
  void solve(const Vector& load, Vector& solution);

  std::vector<BedFace> beds;
  MeshShare<dim> share;
  DegreeSpace<dim> space;
  std::vector<int> number;  // of the discretisation, per row of the rank
  std::vector<bool> is_held;
  PolynomialMultigrid<dim> multigrid;
  StiffnessOperator<dim, double> stiffness;
  DealiiReport report;
};

template <int dim>
std::vector<BedFace> DealiiSolver<dim>::Data::bed_faces(
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
void DealiiSolver<dim>::Data::take(const MatrixXd& columns, Index column,
                                   Vector& to) const {
  for (unsigned row = 0; row < number.size(); ++row) {
    const int dof = number[row];
    to.local_element(row) =
        is_held[static_cast<std::size_t>(dof)] ? 0.0 : columns(dof, column);
  }
}

template <int dim>
void DealiiSolver<dim>::Data::give(const Vector& from, double scale,
                                   MatrixXd& columns, Index column) const {
  for (unsigned row = 0; row < number.size(); ++row) {
    columns(number[row], column) = scale * from.local_element(row);
  }
}

/// Sweeps of conjugate gradients on the true residual: the first to its
/// tolerance, each further one shrinks the error and tells what it was.
template <int dim>
void DealiiSolver<dim>::Data::solve(const Vector& load, Vector& solution) {
  constexpr int kSweeps = 6;
  constexpr int kMostIterations = 500;
  constexpr double kFirst = 1e-10;
  constexpr double kLater = 1e-3;
  constexpr double kWanted = 1e-11;
  Vector residual(load);
  Vector step;
  Vector product;
  stiffness.initialize_dof_vector(step);
  stiffness.initialize_dof_vector(product);
  int iterations = 0;
  double correction = 1.0;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    dealii::IterationNumberControl control(
        kMostIterations, (sweep == 0 ? kFirst : kLater) * residual.l2_norm());
    dealii::SolverFlexibleCG<Vector> cg(control);
    step = 0.0;
    cg.solve(stiffness, step, residual, multigrid);
    iterations += static_cast<int>(control.last_step());
    solution += step;
    const double size = solution.l2_norm();
    correction = size > 0.0 ? step.l2_norm() / size : 0.0;
    stiffness.vmult(product, solution);
    residual = load;
    residual -= product;
    if (sweep > 0 && correction * kLater < kWanted) break;
  }
  report.iterations = std::max(report.iterations, iterations);
  report.correction = std::max(report.correction, correction * kLater);
}

template <int dim>
DealiiSolver<dim>::DealiiSolver(const Discretization<dim>& discretization,
                                const part::Material& material,
                                const FoundationStiffness<dim>& bed,
                                const std::vector<int>& held,
                                const std::string& place, bool is_shared)
    : data_(std::make_unique<Data>(discretization, material, bed, held, place,
                                   is_shared)) {
  data_->report.levels = static_cast<int>(data_->multigrid.levels());
}

template <int dim>
DealiiSolver<dim>::~DealiiSolver() = default;

template <int dim>
MatrixXd DealiiSolver<dim>::solve(const MatrixXd& loads) {
  Data& d = *data_;
  MatrixXd result = MatrixXd::Zero(loads.rows(), loads.cols());
  Vector load;
  Vector solution;
  d.stiffness.initialize_dof_vector(load);
  d.stiffness.initialize_dof_vector(solution);
  for (Index column = 0; column < loads.cols(); ++column) {
    d.take(loads, column, load);
    const double scale = load.l2_norm();
    if (!(scale > 0.0)) continue;
    load /= scale;
    solution = 0.0;
    d.solve(load, solution);
    d.give(solution, scale, result, column);
  }
  share_rows(result, d.share.ranks());
  return result;
}

template <int dim>
MatrixXd DealiiSolver<dim>::multiply_absolute_diagonal(
    const MatrixXd& columns) const {
  const Data& d = *data_;
  const Vector diagonal = d.stiffness.diagonal();
  MatrixXd result = MatrixXd::Zero(columns.rows(), columns.cols());
  for (unsigned row = 0; row < d.number.size(); ++row) {
    result.row(d.number[row]) = std::abs(diagonal.local_element(row)) *
                                columns.row(d.number[row]).cwiseAbs();
  }
  share_rows(result, d.share.ranks());
  return result;
}

template <int dim>
const DealiiReport& DealiiSolver<dim>::report() const {
  return data_->report;
}

template bool suits_dealii<2>(const Discretization<2>&);
template bool suits_dealii<3>(const Discretization<3>&);
template void require_suits_dealii<2>(const Discretization<2>&,
                                      const std::string&);
template void require_suits_dealii<3>(const Discretization<3>&,
                                      const std::string&);
template class DealiiSolver<2>;
template class DealiiSolver<3>;

}  // namespace clevis::elasticity
