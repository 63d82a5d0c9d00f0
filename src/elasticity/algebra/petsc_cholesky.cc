#include <petscmat.h>

#include "base/messages/errors.h"
#include "elasticity/algebra/sparse_cholesky.h"
#include "elasticity/engine_library/cholesky_entry.h"
#include "elasticity/engine_library/engine_library.h"
#include "elasticity/engine_library/petsc_session.h"

namespace clevis::elasticity {

namespace {

class CholmodFactor final : public PetscCholesky {
 public:
  CholmodFactor(const UpperTriangle& matrix, const std::string& name);
  ~CholmodFactor() override {
    MatDestroy(&factor_);
    MatDestroy(&stiffness_);
  }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const override;

 private:
  std::string name_;
  UpperTriangle matrix_;  // PETSc borrows its arrays
  Mat stiffness_ = nullptr;
  Mat factor_ = nullptr;
};

CholmodFactor::CholmodFactor(const UpperTriangle& matrix,
                             const std::string& name)
    : name_(name), matrix_(matrix) {
  start_petsc();
  const int n = matrix.rows();
  require_petsc(MatCreateSeqSBAIJWithArrays(
                    PETSC_COMM_SELF, 1, n, n, matrix_.row_start.data(),
                    matrix_.column.data(), matrix_.value.data(), &stiffness_),
                name, "MatCreateSeqSBAIJWithArrays");
  require_petsc(MatSetOption(stiffness_, MAT_SPD, PETSC_TRUE), name,
                "MatSetOption");
  // CHOLMOD by itself is content with minimum degree; nested dissection
  // gives the better factor for solids and is worth the trial.
  PetscOptionsSetValue(nullptr, "-mat_cholmod_nmethods", "3");
  require_petsc(
      MatGetFactor(stiffness_, MATSOLVERCHOLMOD, MAT_FACTOR_CHOLESKY, &factor_),
      name, "MatGetFactor");
  MatFactorInfo info;
  MatFactorInfoInitialize(&info);
  require_petsc(MatCholeskyFactorSymbolic(factor_, stiffness_, nullptr, &info),
                name, "symbolic factorisation");
  require_petsc(MatCholeskyFactorNumeric(factor_, stiffness_, &info), name,
                "numeric factorisation (matrix not positive definite)");
  MatFactorError error{};
  require_petsc(MatFactorGetError(factor_, &error), name, "MatFactorGetError");
  if (error != MAT_FACTOR_NOERROR) {
    throw Error("F002", name, "the stiffness matrix is not positive definite",
                "Check the mesh quality and the material.");
  }
}

Eigen::MatrixXd CholmodFactor::solve(
    const Eigen::MatrixXd& right_hand_sides) const {
  const auto rows = static_cast<PetscInt>(right_hand_sides.rows());
  const auto columns = static_cast<PetscInt>(right_hand_sides.cols());
  if (columns == 0) return right_hand_sides;  // CHOLMOD refuses an empty block
  Eigen::MatrixXd b = right_hand_sides;
  Eigen::MatrixXd x(rows, columns);
  Mat dense_b = nullptr;
  Mat dense_x = nullptr;
  require_petsc(
      MatCreateSeqDense(PETSC_COMM_SELF, rows, columns, b.data(), &dense_b),
      name_, "MatCreateSeqDense");
  require_petsc(
      MatCreateSeqDense(PETSC_COMM_SELF, rows, columns, x.data(), &dense_x),
      name_, "MatCreateSeqDense");
  const PetscErrorCode code = MatMatSolve(factor_, dense_b, dense_x);
  MatDestroy(&dense_b);
  MatDestroy(&dense_x);
  require_petsc(code, name_, "MatMatSolve");
  return x;
}

}  // namespace

CLEVIS_ENGINE_ENTRY std::unique_ptr<PetscCholesky> clevis_petsc_cholesky(
    const UpperTriangle& matrix, const std::string& name) {
  return std::make_unique<CholmodFactor>(matrix, name);
}

}  // namespace clevis::elasticity
