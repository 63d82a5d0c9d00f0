#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "numerics/integrators/low_rank_jacobian.h"
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
  bool factor(double h) { return jacobian_.factor(*method_, h); }
  /// Derivative of the rate at the last linearise(), and its factors.
  LowRankJacobian& jacobian() { return jacobian_; }
  const LowRankJacobian& jacobian() const { return jacobian_; }

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

  long evaluations() const { return evaluations_; }

  int most_iterations() const { return 2 + 2 * method_->stages; }

 private:
  std::size_t count() const { return method_->count(); }
  void newton_step(const Eigen::VectorXd& y, double h);
  void to_axes(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> v) const;
  void from_axes(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> v) const;

  OdeSystem& system_;
  const RadauMethod* method_ = &radau_method(3);
  const RadauMethod* kept_method_ = method_;  ///< of kept_
  Axes axes_ = Axes::kFixed;
  int iterations_{};
  double contraction_{};
  long evaluations_{};
  LowRankJacobian jacobian_;
  Stages z_, w_, f_;
  // Efforts are unknowns beside z, so that Newton does not multiply what it
  // misjudges of a direction by the stiffness of what acts along it
  Stages phi_, kept_, rho_;  ///< by stage; what their laws say less phi
  Eigen::VectorXd phi_now_, phi_beyond_;
  Eigen::MatrixXd G_, L_;  ///< rates by efforts; efforts by tangents
  Eigen::VectorXd point_, along_;
};

/// Root mean square of error times weights.
double weighted_norm(const Eigen::VectorXd& error,
                     const Eigen::VectorXd& weights);

}  // namespace clevis::numerics
