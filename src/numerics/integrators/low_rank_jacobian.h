#pragma once

#include <array>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "numerics/integrators/radau_method.h"

namespace clevis::numerics {

/// Derivative J ≈ B T⁺ of a rate along the tangents T of its system alone, and
/// the factors of γ/h − J for the real eigenvalue and the complex pairs γ of
/// an implicit method: (γ − J)⁻¹ = (1 + B (γ − T⁺ B)⁻¹ T⁺) / γ.
class LowRankJacobian {
 public:
  /// @param size  of the state.
  explicit LowRankJacobian(Eigen::Index size);

  /// Columns T and their images B = J T, to be filled before take(); size ×
  /// size, the first ones count.
  Eigen::MatrixXd& tangents() { return T_; }
  Eigen::MatrixXd& images() { return B_; }
  /// Takes this many columns in; drops the factors.
  void take(Eigen::Index tangents);

  /// Decomposes for a step h [s]. @return false if that fails.
  bool factor(const RadauMethod& method, double h);
  bool is_factored_for(double h) const { return h == h_; }
  void drop_factors() { h_ = 0.0; }
  long factorisations() const { return factorisations_; }

  /// result ← T⁺ v.
  void along_tangents(const Eigen::VectorXd& v, Eigen::VectorXd& result) const {
    result.noalias() = to_tangents_ * v;
  }
  /// v ← (γ₀/h − J)⁻¹ v.
  void filter(Eigen::VectorXd& v);
  /// u + i v ← (γ/h − J)⁻¹ (u + i v), γ of the pair.
  void filter_pair(std::size_t pair, Eigen::VectorXd& u, Eigen::VectorXd& v);
  /// Largest growth of a vector by J in a few power iterations [1/s].
  double stiffness();
  /// About the size of its largest eigenvalue [1/s].
  double largest_eigenvalue();

 private:
  void apply(const Eigen::VectorXd& v, Eigen::VectorXd& result);

  Eigen::Index tangents_{};  ///< columns of T and B that count
  Eigen::MatrixXd T_, B_, gram_, to_tangents_, reduced_, matrix_;
  Eigen::MatrixXcd complex_matrix_;
  Eigen::LDLT<Eigen::MatrixXd> gram_factor_;
  Eigen::PartialPivLU<Eigen::MatrixXd> real_;
  std::array<Eigen::PartialPivLU<Eigen::MatrixXcd>, 3> complex_;
  const RadauMethod* method_{};  ///< of the factors
  double h_ = 0.0;               ///< of the factors
  long factorisations_{};
  Eigen::VectorXd scratch_, direction_, along_;
  Eigen::VectorXcd complex_scratch_, complex_along_;
};

}  // namespace clevis::numerics
