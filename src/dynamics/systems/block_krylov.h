#pragma once

#include <functional>

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// Entries from -1/2 to 1/2, the same on every run and platform.
Eigen::MatrixXd random_block(Eigen::Index rows, Eigen::Index columns);

/// An operator T that is self-adjoint in the inner product of a matrix M:
/// M T = Tᵀ M.
struct SelfAdjoint {
  Eigen::Index size{};
  BlockOperator product;  ///< X -> M X
  /// X, M X -> T X.
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd& block,
                                const Eigen::MatrixXd& weighted)>
      apply;
  BlockOperator admitted = {};  ///< as of LinearSystem
};

/// Space of T applied again and again to a block, M-orthonormal, with the
/// operator's projection on it. Of vibrations T is (K + s M)⁻¹ M, whose
/// eigenvalues θ = 1/(ω² + s) are largest for the lowest frequencies.
///
/// All vectors are orthogonalised against all others, twice: the loss of
/// orthogonality that makes eigenvalues appear again does not arise. A block
/// finds eigenvalues as often as they occur, up to its width.
///
/// Source: [GolubUnderwood1977], [GrimesLewisSimon1994].
class BlockKrylov {
 public:
  /// @param solve     B -> (K + s M)⁻¹ B.
  /// @param start     block, need not be independent.
  /// @param deflated  M-orthonormal vectors that stay out; may be empty.
  BlockKrylov(const LinearSystem& system, BlockOperator solve,
              const Eigen::MatrixXd& start, Eigen::MatrixXd deflated);
  BlockKrylov(SelfAdjoint system, const Eigen::MatrixXd& start,
              Eigen::MatrixXd deflated);

  /// Adds a block; the space may close under the operator: then none.
  void extend();

  Eigen::Index size() const { return done_; }
  bool is_closed() const { return columns_ == done_; }

  /// Eigenvectors of the projection: the best of this space.
  struct RitzValues {
    Eigen::VectorXd theta;     ///< falling [s²]
    Eigen::MatrixXd vectors;   ///< in the space, size × size
    Eigen::VectorXd residual;  ///< ‖T x − θ x‖_M [s²]
  };
  RitzValues ritz_values() const;

  /// The first `size()` vectors of the space.
  auto basis() const { return basis_.leftCols(done_); }

 private:
  /// Takes out of `block` what lies in the space; returns the components.
  /// @param weighted  M block.
  Eigen::MatrixXd take_out(Eigen::MatrixXd& block,
                           const Eigen::MatrixXd& weighted) const;
  /// The same twice.
  /// @param scale  gets the largest square of a column in M, before.
  Eigen::MatrixXd orthogonalise(Eigen::MatrixXd& block, double& scale) const;
  bool settle(const Eigen::MatrixXd& columns, Eigen::MatrixXd& column,
              Eigen::MatrixXd& image) const;
  /// M-orthonormal columns that span the block's, which are the next of the
  /// space.
  /// @param scale  square of what the block was before it was orthogonalised:
  ///   what is 1e-11 of it is round-off.
  /// @return T with block = columns · T.
  Eigen::MatrixXd append(const Eigen::MatrixXd& block, double scale);

  SelfAdjoint system_;
  Eigen::MatrixXd deflated_;
  Eigen::MatrixXd basis_;       ///< with room for more
  Eigen::MatrixXd weighted_;    ///< M times the block that is next
  Eigen::Index columns_ = 0;    ///< of basis_, with the block that is next
  Eigen::Index done_ = 0;       ///< of basis_, that T was applied to
  Eigen::MatrixXd projection_;  ///< basisᵀ M T basis, with room for more
  Eigen::MatrixXd overhang_;    ///< M-components of T basis on the next block
};

/// The columns' span as M-orthonormal columns.
Eigen::MatrixXd mass_orthonormal(const LinearSystem& system,
                                 const Eigen::MatrixXd& columns);

}  // namespace clevis::dynamics
