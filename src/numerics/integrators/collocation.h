#pragma once

#include <array>
#include <complex>
#include <cstdint>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "numerics/integrators/ode_system.h"
#include "numerics/integrators/radau_method.h"

namespace clevis::numerics {

/// The stages z_i of Radau IIA over one step; see RadauMethod. Simplified
/// Newton in the coordinates w = T⁻¹ z in which the method's matrix is a real
/// eigenvalue and complex pairs ([HairerWanner1996] IV.8); along the tangents
/// of the system alone, each stage in axes of its own.
class Collocation {
 public:
  explicit Collocation(OdeSystem& system);

  /// One vector per stage; the first of them count, as many as the method has.
  using Stages = std::array<Eigen::VectorXd, RadauMethod::kMostStages>;

  void use(const RadauMethod& method);
  const RadauMethod& method() const { return *method_; }

  /// Of the derivative of the rate: those of the state, or those that go along
  /// with it.
  enum class Axes : std::uint8_t { kFixed, kMoving };

  /// The rate at (t, y) as the laws of efforts say; these hold from then on.
  void start(double t, const Eigen::VectorXd& y, Eigen::VectorXd& slope);
  /// The rate at (t, y) under the efforts that hold; v: and what the
  /// derivative adds to them as the state goes on by v.
  void slope(double t, const Eigen::VectorXd& y, Eigen::VectorXd& slope);
  void slope_beyond(double t, const Eigen::VectorXd& y,
                    const Eigen::VectorXd& v, Eigen::VectorXd& slope);
  /// Derivative of the rate at (t, y) along the system's tangents(), by
  /// differences that hold_tangents(). @param slope  of slope().
  void linearise(double t, const Eigen::VectorXd& y,
                 const Eigen::VectorXd& slope, Axes axes);
  /// Decomposes for a step h. @return false if that fails.
  bool factor(double h);
  bool is_factored_for(double h) const { return h == h_; }

  /// Solves for the stages from the guess in stages().
  /// @param weights  of OdeSystem::error_weights().
  /// @return whether it converged to kConverged of the error allowed.
  bool solve(double t, const Eigen::VectorXd& y, double h,
             const Eigen::VectorXd& weights);

  Stages& stages() { return z_; }
  /// Efforts at the stages: those that hold, or as the polynomial through
  /// the ones of the last accept() goes on. @param s  time since the start of
  ///   its step, in such steps.
  void guess_efforts();
  void guess_efforts(const RadauMethod::Weights& s);
  /// The stages are part of the motion: their last efforts hold from now on.
  void accept();
  int iterations() const { return iterations_; }  ///< of the last solve()
  double contraction() const { return contraction_; }
  /// v ← (γ₀/h − J)⁻¹ v at y.
  void filter(const Eigen::VectorXd& y, Eigen::VectorXd& v);
  /// Stages' part of the embedded error, over h.
  void embedded(double h, Eigen::VectorXd& sum) const;
  /// Largest growth of a vector by J in a few power iterations [1/s].
  double stiffness();
  /// About the size of its largest eigenvalue [1/s].
  double largest_eigenvalue();

  long evaluations() const { return evaluations_; }
  long factorisations() const { return factorisations_; }

  int most_iterations() const { return 2 + 2 * method_->stages; }

 private:
  std::size_t count() const { return method_->count(); }
  std::size_t pairs() const { return count() / 2; }
  void newton_step(const Eigen::VectorXd& y, double h);
  void filter_pair(std::size_t pair, double h);
  void filter_in_axes(Eigen::VectorXd& v);
  void to_axes(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> v) const;
  void from_axes(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> v) const;
  void apply_jacobian(const Eigen::VectorXd& v, Eigen::VectorXd& result);

  OdeSystem& system_;
  const RadauMethod* method_ = &radau_method(3);
  const RadauMethod* kept_method_ = method_;  ///< of kept_
  Axes axes_ = Axes::kFixed;
  double h_ = 0.0;  ///< of the factors
  int iterations_{};
  double contraction_{};
  long evaluations_{}, factorisations_{};
  // J ≈ B T⁺, T the tangents: (γ − J)⁻¹ = (1 + B (γ − T⁺ B)⁻¹ T⁺) / γ
  Eigen::Index tangents_{};  ///< columns of T and B that count
  Eigen::MatrixXd T_, B_, gram_, to_tangents_, reduced_, matrix_;
  Eigen::MatrixXcd complex_matrix_;
  Eigen::LDLT<Eigen::MatrixXd> gram_factor_;
  Eigen::PartialPivLU<Eigen::MatrixXd> real_;
  std::array<Eigen::PartialPivLU<Eigen::MatrixXcd>, 3> complex_;
  Stages z_, w_, f_;
  // Efforts are unknowns beside z, so that Newton does not multiply what it
  // misjudges of a direction by the stiffness of what acts along it
  Stages phi_, kept_, rho_;  ///< by stage; what their laws say less phi
  Eigen::VectorXd phi_now_, phi_beyond_;
  Eigen::MatrixXd G_, L_;  ///< rates by efforts; efforts by tangents
  Eigen::VectorXd point_, scratch_, direction_, along_;
  Eigen::VectorXcd complex_scratch_, complex_along_;
};

/// Root mean square of error times weights.
double weighted_norm(const Eigen::VectorXd& error,
                     const Eigen::VectorXd& weights);

}  // namespace clevis::numerics
