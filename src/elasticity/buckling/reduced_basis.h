#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace clevis::elasticity {

/// Vectors in which y − A y = b is solved by Galerkin's method for many A, each
/// a sum of amounts of the same few self-adjoint terms. What the terms make of
/// the vectors is kept, so that the residual of the whole is known.
class ReducedBasis {
 public:
  /// @param sources  of what acts through few values of y (Action::drawn),
  ///   equations × values [√J].
  explicit ReducedBasis(const Eigen::MatrixXd& sources);

  Eigen::Index equations() const { return kept_.rows(); }
  Eigen::Index size() const { return vectors_.cols(); }
  std::size_t terms() const { return terms_.size(); }
  /// Orthonormal, equations × size().
  const Eigen::MatrixXd& vectors() const { return vectors_; }

  /// Whether what is kept leaves memory for so many columns more.
  bool has_room(Eigen::Index columns) const;
  /// Leaves the sources and the terms without an image.
  void clear();
  /// What columns have beside the basis, orthonormal; less where memory ends.
  Eigen::MatrixXd beside(const Eigen::MatrixXd& columns) const;
  /// @param vectors  of beside() [1]. @param images  by each of the terms [1].
  void append(const Eigen::MatrixXd& vectors,
              const std::vector<Eigen::MatrixXd>& images);
  /// @param image  of the basis, equations × size() [1].
  void append_term(const Eigen::MatrixXd& image);

  struct Action {
    Eigen::VectorXd terms;  ///< amounts
    Eigen::MatrixXd drawn;  ///< of the sources by each vector
  };
  struct Solution {
    /// Whether 1 bounds the eigenvalues of A in the basis; else no solution.
    bool is_stable = false;
    Eigen::VectorXd amounts;  ///< of the vectors
    double residual{};        ///< norm, of all equations
  };
  /// @param b  [√J].
  Solution solve(const Action& action, const Eigen::VectorXd& b) const;
  /// b − y + A y of a solution [√J].
  Eigen::VectorXd residual(const Action& action, const Eigen::VectorXd& b,
                           const Eigen::VectorXd& amounts) const;

 private:
  using Places = std::vector<Eigen::Index>;  ///< columns of kept_

  Places keep(const Eigen::MatrixXd& columns);
  /// b's share outside of the basis and this, of what is kept, are the
  /// residual.
  Eigen::VectorXd kept_amounts(const Action& action,
                               const Eigen::VectorXd& rest,
                               const Eigen::VectorXd& amounts) const;

  Eigen::MatrixXd vectors_;
  Eigen::MatrixXd kept_;  ///< sources, vectors and their images
  Eigen::MatrixXd gram_;  ///< kept_ᵀ kept_
  Places sources_, own_;
  std::vector<Places> terms_;
};

}  // namespace clevis::elasticity
