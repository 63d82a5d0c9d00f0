#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/algebra/dense_blocks.h"
#include "elasticity/algebra/large_buffer.h"
#include "elasticity/algebra/matrix_rows.h"
#include "elasticity/direct/front_tree.h"

namespace clevis::elasticity {

/// Multifrontal Cholesky factorisation on the tree of a nested dissection of
/// the cells. Fronts are dense and known before the matrix: nothing is
/// searched for entry by entry, and all arithmetic is that of dense blocks.
/// Threads take subtrees, and blocks of the fronts above them; the same bits
/// for any number of threads.
///
/// Source: [DuffReid1983], [Liu1992].
/// @tparam Real  of the factor: float needs half the time and memory and holds
///   seven digits.
template <typename Real>
class FrontalFactor {
 public:
  /// @param matrix  couples only equations whose nodes share a cell.
  /// @param name    entity for messages ("part DCE").
  /// @throws Error F002 if the matrix is not positive definite.
  FrontalFactor(const MatrixRows& matrix, FrontTree tree,
                const std::string& name, int threads = 1);

  /// X with A X = B, all columns as one block.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;

  /// With A = F Fᵀ: F⁻¹ B and F⁻ᵀ Y, whose Y counts the unknowns in the order
  /// of elimination. With X = F⁻ᵀ Y, Xᵀ A X = Yᵀ Y.
  Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& right_hand_sides) const;
  Eigen::MatrixXd solve_upper(const Eigen::MatrixXd& ordered) const;

 private:
  Panel<Real> panel(std::size_t front) const {
    return {factor_.get() + start_[front], tree_.fronts[front].own(),
            tree_.fronts[front].later()};
  }
  void forward_all(MatrixOf<Real>& ordered) const;
  void backward_all(MatrixOf<Real>& ordered) const;

  FrontTree tree_;
  std::vector<std::size_t> start_;  ///< of each front's panel in factor_
  /// Per front: own + border rows × own columns, by columns.
  LargeBuffer<Real> factor_;
};

using FrontalCholesky = FrontalFactor<double>;

}  // namespace clevis::elasticity
