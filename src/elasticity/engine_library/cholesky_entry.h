#pragma once

#include <memory>
#include <string>

#include <Eigen/Core>

namespace clevis::elasticity {

struct UpperTriangle;

/// The part of SparseCholesky, in the units of its matrix [SI], that is in the
/// library of deal.II and PETSc.
class PetscCholesky {
 public:
  virtual ~PetscCholesky() = default;
  virtual Eigen::MatrixXd solve(
      const Eigen::MatrixXd& right_hand_sides) const = 0;
};

/// The library's function that makes one, and its name.
using CholeskyEntry = std::unique_ptr<PetscCholesky>(
    const UpperTriangle& matrix, const std::string& name);
inline constexpr const char* kCholeskyEntry = "clevis_petsc_cholesky";

}  // namespace clevis::elasticity
