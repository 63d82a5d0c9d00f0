#include "elasticity/algebra/sparse_cholesky.h"

#include <limits>

#include "base/messages/errors.h"
#include "elasticity/engine_library/cholesky_entry.h"
#include "elasticity/engine_library/engine_library.h"

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
  std::unique_ptr<PetscCholesky> factor;
};

SparseCholesky::SparseCholesky(const UpperTriangle& matrix,
                               const std::string& name)
    : petsc_(new Petsc{
          engine_function<CholeskyEntry>(kCholeskyEntry)(matrix, name)}) {}

SparseCholesky::~SparseCholesky() = default;

Eigen::MatrixXd SparseCholesky::solve(
    const Eigen::MatrixXd& right_hand_sides) const {
  return petsc_->factor->solve(right_hand_sides);
}

}  // namespace clevis::elasticity
