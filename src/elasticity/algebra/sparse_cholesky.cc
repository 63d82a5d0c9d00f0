#include "elasticity/algebra/sparse_cholesky.h"

#include <limits>

#include <petscmat.h>

#include "base/errors.h"
#include "elasticity/algebra/petsc_session.h"

namespace clevis::elasticity {

int entry_number(std::size_t entries) {
  if (entries > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw Error("F004", "linear system",
                "its matrix has more than 2^31 - 1 entries",
                "Mesh the part coarser.");
  }
  return static_cast<int>(entries);
}

struct SparseCholesky::Petsc {
  std::string name;
  UpperTriangle matrix;  // PETSc borrows its arrays
  Mat stiffness = nullptr;
  Mat factor = nullptr;

  ~Petsc() {
    MatDestroy(&factor);
    MatDestroy(&stiffness);
  }
};

SparseCholesky::SparseCholesky(const UpperTriangle& matrix,
                               const std::string& name)
    : petsc_(std::make_unique<Petsc>()) {
  start_petsc();
  Petsc& p = *petsc_;
  p.name = name;
  p.matrix = matrix;
  const int n = matrix.rows();
  require_petsc(
      MatCreateSeqSBAIJWithArrays(
          PETSC_COMM_SELF, 1, n, n, p.matrix.row_start.data(),
          p.matrix.column.data(), p.matrix.value.data(), &p.stiffness),
      name, "MatCreateSeqSBAIJWithArrays");
  require_petsc(MatSetOption(p.stiffness, MAT_SPD, PETSC_TRUE), name,
                "MatSetOption");
  // CHOLMOD by itself is content with minimum degree; nested dissection
  // gives the better factor for solids and is worth the trial.
  PetscOptionsSetValue(nullptr, "-mat_cholmod_nmethods", "3");
  require_petsc(MatGetFactor(p.stiffness, MATSOLVERCHOLMOD, MAT_FACTOR_CHOLESKY,
                             &p.factor),
                name, "MatGetFactor");
  MatFactorInfo info;
  MatFactorInfoInitialize(&info);
  require_petsc(
      MatCholeskyFactorSymbolic(p.factor, p.stiffness, nullptr, &info), name,
      "symbolic factorisation");
  require_petsc(MatCholeskyFactorNumeric(p.factor, p.stiffness, &info), name,
                "numeric factorisation (matrix not positive definite)");
  MatFactorError error{};
  require_petsc(MatFactorGetError(p.factor, &error), name, "MatFactorGetError");
  if (error != MAT_FACTOR_NOERROR) {
    throw Error("F002", name, "the stiffness matrix is not positive definite",
                "Check the mesh quality and the material.");
  }
}

SparseCholesky::~SparseCholesky() = default;

Eigen::MatrixXd SparseCholesky::solve(
    const Eigen::MatrixXd& right_hand_sides) const {
  const auto rows = static_cast<PetscInt>(right_hand_sides.rows());
  const auto columns = static_cast<PetscInt>(right_hand_sides.cols());
  if (columns == 0) return right_hand_sides;  // CHOLMOD refuses an empty block
  Eigen::MatrixXd b = right_hand_sides;
  Eigen::MatrixXd x(rows, columns);
  Mat dense_b = nullptr;
  Mat dense_x = nullptr;
  const std::string& name = petsc_->name;
  require_petsc(
      MatCreateSeqDense(PETSC_COMM_SELF, rows, columns, b.data(), &dense_b),
      name, "MatCreateSeqDense");
  require_petsc(
      MatCreateSeqDense(PETSC_COMM_SELF, rows, columns, x.data(), &dense_x),
      name, "MatCreateSeqDense");
  const PetscErrorCode code = MatMatSolve(petsc_->factor, dense_b, dense_x);
  MatDestroy(&dense_b);
  MatDestroy(&dense_x);
  require_petsc(code, name, "MatMatSolve");
  return x;
}

}  // namespace clevis::elasticity
