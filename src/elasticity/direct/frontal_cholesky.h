#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/algebra/sparse_cholesky.h"
#include "elasticity/direct/front_tree.h"
#include "elasticity/direct/large_buffer.h"

namespace clevis::elasticity {

/// Multifrontal Cholesky factorisation on the tree of a nested dissection of
/// the cells. Fronts are dense and known before the matrix: nothing is
/// searched for entry by entry, and all arithmetic is that of dense blocks.
///
/// Source: [DuffReid1983], [Liu1992].
class FrontalCholesky {
 public:
  /// @param matrix  couples only equations whose nodes share a cell.
  /// @param name    entity for messages ("part DCE").
  /// @throws Error F002 if the matrix is not positive definite.
  FrontalCholesky(const UpperTriangle& matrix, FrontTree tree,
                  const std::string& name);

  /// X with A X = B, all columns as one block.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;

  /// With A = F Fᵀ: F⁻¹ B and F⁻ᵀ Y, whose Y counts the unknowns in the order
  /// of elimination. With X = F⁻ᵀ Y, Xᵀ A X = Yᵀ Y.
  Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& right_hand_sides) const;
  Eigen::MatrixXd solve_upper(const Eigen::MatrixXd& ordered) const;

 private:
  void factor(const UpperTriangle& ordered, const std::string& name);
  const double* panel(std::size_t front) const {
    return factor_.get() + start_[front];
  }

  FrontTree tree_;
  std::vector<std::size_t> start_;  ///< of each front's panel in factor_
  /// Per front: own + border rows × own columns, by columns.
  LargeBuffer factor_;
};

}  // namespace clevis::elasticity
