#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clevis::elasticity {

/// Upper triangle of a symmetric matrix, rows compressed, columns sorted.
struct UpperTriangle {
  std::vector<int> row_start;  ///< rows + 1
  std::vector<int> column;
  std::vector<double> value;
  int rows() const { return static_cast<int>(row_start.size()) - 1; }
};

/// So many entries as a row start.
/// @throws Error F004 if they are too many to be numbered by an int.
int entry_number(std::size_t entries);

/// Sparse Cholesky factorisation of a matrix without a tree of fronts: PETSc
/// with CHOLMOD, supernodal, in an order of its own.
///
/// PETSc is initialised once per process, without MPI's launcher.
class SparseCholesky {
 public:
  /// @param name  entity for messages ("part DCE").
  /// @throws Error F002 if the matrix is not positive definite.
  SparseCholesky(const UpperTriangle& matrix, const std::string& name);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// X with A X = B, all columns as one block.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;

 private:
  struct Petsc;
  std::unique_ptr<Petsc> petsc_;
};

}  // namespace clevis::elasticity
