#include "elasticity/dealii_levels/coarse_solver.h"

#include <array>
#include <map>
#include <utility>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/sparsity_tools.h>
#include <petscksp.h>

#include "base/messages/errors.h"
#include "elasticity/engine_library/petsc_session.h"

namespace clevis::elasticity {
namespace {

// What solves within PETSc's telescope, and the smoother of GAMG's levels, are
// set by options alone.
constexpr const char* kFactorPrefix = "clevis_factor_";
constexpr std::array<std::pair<const char*, const char*>, 3> kFactorOptions{{
    {"-clevis_factor_telescope_ksp_type", "preonly"},
    {"-clevis_factor_telescope_pc_type", "cholesky"},
    {"-clevis_factor_telescope_pc_factor_mat_solver_type", "mumps"},
}};
constexpr const char* kPrefix = "clevis_coarse_";
constexpr const char* kSmoother = "-clevis_coarse_mg_levels_pc_type";

}  // namespace

template <int dim>
struct CoarseSolver<dim>::Petsc {
  std::string name;
  dealii::PETScWrappers::MPI::SparseMatrix matrix;
  KSP solver = nullptr;
  Vec load = nullptr, solution = nullptr;

  ~Petsc() {
    KSPDestroy(&solver);
    VecDestroy(&load);
    VecDestroy(&solution);
  }
  void require(PetscErrorCode code, const char* stage) const {
    require_petsc(code, name, stage);
  }
  void assemble(const DegreeSpace<dim>& space,
                const StiffnessOperator<dim, double>& stiffness);
  void set_rigid_modes(const DegreeSpace<dim>& space);
  void factor(PC preconditioner, int ranks);
  void coarsen(PC preconditioner);
  void set_up(MPI_Comm ranks, CoarseMethod method);
  bool has_failed(PC preconditioner, MPI_Comm ranks) const;
};

template <int dim>
void CoarseSolver<dim>::Petsc::assemble(
    const DegreeSpace<dim>& space,
    const StiffnessOperator<dim, double>& stiffness) {
  const auto& handler = space.handler();
  const dealii::IndexSet& owned = handler.locally_owned_dofs();
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(handler, relevant);
  dealii::DynamicSparsityPattern pattern(relevant);
  dealii::DoFTools::make_sparsity_pattern(handler, pattern, space.held(),
                                          false);
  dealii::SparsityTools::distribute_sparsity_pattern(
      pattern, owned, space.share().ranks(), relevant);
  matrix.reinit(owned, owned, pattern, space.share().ranks());
  stiffness.visit_cells([&](const auto& entries, const auto& numbers) {
    space.held().distribute_local_to_global(entries, numbers, matrix);
  });
  matrix.compress(dealii::VectorOperation::add);
}

/// The components of a node stand side by side up to degree 2, where each edge,
/// face and cell has one node.
template <int dim>
void CoarseSolver<dim>::Petsc::set_rigid_modes(const DegreeSpace<dim>& space) {
  std::map<dealii::types::global_dof_index, dealii::Point<dim>> positions;
  dealii::DoFTools::map_dofs_to_support_points(space.share().mapping(),
                                               space.handler(), positions);
  Mat stiffness = matrix;
  Vec coordinates = nullptr;
  require(MatSetBlockSize(stiffness, dim), "MatSetBlockSize");
  require(MatCreateVecs(stiffness, &coordinates, nullptr), "MatCreateVecs");
  require(VecSetBlockSize(coordinates, dim), "VecSetBlockSize");
  for (const auto row : space.handler().locally_owned_dofs()) {
    require(VecSetValue(coordinates, static_cast<PetscInt>(row),
                        positions.at(row)[row % dim], INSERT_VALUES),
            "VecSetValue");
  }
  require(VecAssemblyBegin(coordinates), "VecAssemblyBegin");
  require(VecAssemblyEnd(coordinates), "VecAssemblyEnd");
  MatNullSpace modes = nullptr;
  require(MatNullSpaceCreateRigidBody(coordinates, &modes),
          "MatNullSpaceCreateRigidBody");
  require(MatSetNearNullSpace(stiffness, modes), "MatSetNearNullSpace");
  require(MatNullSpaceDestroy(&modes), "MatNullSpaceDestroy");
  require(VecDestroy(&coordinates), "VecDestroy");
}

/// On one rank: a solve by all would be hundreds of messages.
template <int dim>
void CoarseSolver<dim>::Petsc::factor(PC preconditioner, int ranks) {
  require(KSPSetType(solver, KSPPREONLY), "KSPSetType");
  if (ranks == 1) {
    require(PCSetType(preconditioner, PCCHOLESKY), "PCSetType");
    require(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS),
            "PCFactorSetMatSolverType");
    return;
  }
  require(PCSetType(preconditioner, PCTELESCOPE), "PCSetType");
  require(PCTelescopeSetReductionFactor(preconditioner, ranks),
          "PCTelescopeSetReductionFactor");
  require(KSPSetOptionsPrefix(solver, kFactorPrefix), "KSPSetOptionsPrefix");
  for (const auto& [option, value] : kFactorOptions) {
    require(PetscOptionsSetValue(nullptr, option, value),
            "PetscOptionsSetValue");
  }
  require(KSPSetFromOptions(solver), "KSPSetFromOptions");
}

template <int dim>
void CoarseSolver<dim>::Petsc::coarsen(PC preconditioner) {
  constexpr double kReduction = 1e-6;
  constexpr int kMostIterations = 50;
  require(KSPSetType(solver, KSPCG), "KSPSetType");
  require(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED), "KSPSetNormType");
  require(KSPSetTolerances(solver, kReduction, PETSC_DEFAULT, PETSC_DEFAULT,
                           kMostIterations),
          "KSPSetTolerances");
  require(PCSetType(preconditioner, PCGAMG), "PCSetType");
  // Its default squares the graph first; slender parts do not converge so.
  require(PCGAMGSetAggressiveLevels(preconditioner, 0),
          "PCGAMGSetAggressiveLevels");
  require(KSPSetOptionsPrefix(solver, kPrefix), "KSPSetOptionsPrefix");
  require(PetscOptionsSetValue(nullptr, kSmoother, "sor"),
          "PetscOptionsSetValue");
  require(KSPSetFromOptions(solver), "KSPSetFromOptions");
}

template <int dim>
void CoarseSolver<dim>::Petsc::set_up(MPI_Comm ranks, CoarseMethod method) {
  Mat stiffness = matrix;
  require(MatSetOption(stiffness, MAT_SPD, PETSC_TRUE), "MatSetOption");
  require(MatCreateVecs(stiffness, &solution, &load), "MatCreateVecs");
  require(KSPCreate(ranks, &solver), "KSPCreate");
  require(KSPSetOperators(solver, stiffness, stiffness), "KSPSetOperators");
  PC preconditioner = nullptr;
  require(KSPGetPC(solver, &preconditioner), "KSPGetPC");
  if (method == CoarseMethod::kFactor) {
    int count = 1;
    MPI_Comm_size(ranks, &count);
    factor(preconditioner, count);
  } else {
    coarsen(preconditioner);
  }
  require(KSPSetUp(solver), "KSPSetUp");
  if (has_failed(preconditioner, ranks)) {
    throw Error("F002", name, "the stiffness matrix is not positive definite",
                "Check the mesh quality and the material.");
  }
}

/// The same on all ranks, though one alone may factor.
template <int dim>
bool CoarseSolver<dim>::Petsc::has_failed(PC preconditioner,
                                          MPI_Comm ranks) const {
  PetscBool is_telescope = PETSC_FALSE;
  require(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioner),
                                 PCTELESCOPE, &is_telescope),
          "PetscObjectTypeCompare");
  PC own = preconditioner;
  if (is_telescope == PETSC_TRUE) {
    KSP inner = nullptr;
    own = nullptr;
    require(PCTelescopeGetKSP(preconditioner, &inner), "PCTelescopeGetKSP");
    if (inner != nullptr) require(KSPGetPC(inner, &own), "KSPGetPC");
  }
  PCFailedReason reason = PC_NOERROR;
  if (own != nullptr) {
    require(PCGetFailedReason(own, &reason), "PCGetFailedReason");
  }
  int failed = reason == PC_NOERROR ? 0 : 1;
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, ranks);
  return failed != 0;
}

template <int dim>
CoarseSolver<dim>::CoarseSolver(const DegreeSpace<dim>& space,
                                const StiffnessOperator<dim, double>& stiffness,
                                CoarseMethod method, const std::string& name)
    : petsc_(std::make_unique<Petsc>()) {
  petsc_->name = name;
  petsc_->assemble(space, stiffness);
  if (method == CoarseMethod::kMultigrid) petsc_->set_rigid_modes(space);
  petsc_->set_up(space.share().ranks(), method);
}

template <int dim>
CoarseSolver<dim>::~CoarseSolver() = default;

template <int dim>
void CoarseSolver<dim>::solve(Vector& x, const Vector& b) const {
  const Petsc& p = *petsc_;
  double* values = nullptr;
  p.require(VecGetArray(p.load, &values), "VecGetArray");
  for (unsigned i = 0; i < b.locally_owned_size(); ++i) {
    values[i] = b.local_element(i);
  }
  p.require(VecRestoreArray(p.load, &values), "VecRestoreArray");
  p.require(KSPSolve(p.solver, p.load, p.solution), "KSPSolve");
  const double* result = nullptr;
  p.require(VecGetArrayRead(p.solution, &result), "VecGetArrayRead");
  for (unsigned i = 0; i < x.locally_owned_size(); ++i) {
    x.local_element(i) = static_cast<float>(result[i]);
  }
  p.require(VecRestoreArrayRead(p.solution, &result), "VecRestoreArrayRead");
}

template class CoarseSolver<2>;
template class CoarseSolver<3>;

}  // namespace clevis::elasticity
