#pragma once

#include <Eigen/Core>

namespace clevis::numerics {

/// y' = f(t, y), for the integrators. None of it allocates. Time t is in
/// seconds [s], each component of y in a unit of its own, as the system says.
class OdeSystem {
 public:
  virtual ~OdeSystem() = default;

  virtual int size() const = 0;
  /// f(t, y). Entries that are not finite make the integrator shorten its
  /// step.
  virtual void rate(double t, const Eigen::VectorXd& y,
                    Eigen::VectorXd& rate) = 0;
  /// By component, the inverse of the error that a step may make there; 0
  /// where it does not matter.
  virtual void error_weights(const Eigen::VectorXd& y,
                             Eigen::VectorXd& weights) const = 0;
  /// By component, a size that is large for it; 0 where no rate depends on it.
  virtual void scales(const Eigen::VectorXd& y,
                      Eigen::VectorXd& scales) const = 0;
  /// Directions T in which states go on from (t, y), n × n, of which the first
  /// columns count; each as long as its states are large. What the rate does
  /// along others need not be known to solve for states implicitly.
  /// @return how many count.
  virtual Eigen::Index tangents(double /*t*/, const Eigen::VectorXd& y,
                                Eigen::MatrixXd& T) {
    Eigen::VectorXd size(y.size());
    scales(y, size);
    T = y.cwiseAbs().cwiseMax(size).asDiagonal();
    return y.size();
  }
  /// Turns a change v of the state, or a rate, into axes that go along with
  /// y. Where parts act on one another, the derivative of the rate hardly
  /// changes in these as y goes on; where they touch what is at rest, it does
  /// not in the axes of v.
  virtual void to_axes(const Eigen::VectorXd& /*y*/,
                       Eigen::Ref<Eigen::VectorXd> /*v*/) const {}
  virtual void from_axes(const Eigen::VectorXd& /*y*/,
                         Eigen::Ref<Eigen::VectorXd> /*v*/) const {}
  /// From now on laws that bend within a small change of the state act by
  /// their tangents at (t, y): differences of rate() over steps of any length
  /// give its derivative. Until release_tangents().
  virtual void hold_tangents(double /*t*/, const Eigen::VectorXd& /*y*/) {}
  virtual void release_tangents() {}

  /// Number of stiff scalar efforts φ in which f(t, y, φ) is linear. Each is
  /// given by a law φ(t, y).
  virtual Eigen::Index efforts() const { return 0; }
  /// Holds the efforts at given values, whatever their laws say; nullptr: lets
  /// the laws decide again.
  virtual void hold_efforts(const Eigen::VectorXd* /*given*/) {}
  /// Efforts by their laws, as of the last rate() or hold_tangents().
  virtual void efforts_by_law(Eigen::VectorXd& /*efforts*/) const {}
  /// Derivative of the rate by effort k, as of the last rate().
  virtual void effort_response(Eigen::Index /*k*/,
                               Eigen::Ref<Eigen::VectorXd> /*rate*/) {}
};

/// Work of an integrator so far.
struct StepCounts {
  long steps{}, rejected{}, evaluations{}, factorisations{};
};

/// One accepted step after another, with dense output over the last one.
/// Times are in seconds [s], states as those of the system.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Starts at (t, y); @param step  first trial [s], or 0 to let the
  /// integrator choose.
  virtual void restart(double t, const Eigen::VectorXd& y, double step) = 0;
  /// Takes one step that ends at `limit` at the latest.
  /// @return false if no step of a representable length is good enough.
  virtual bool step(double limit) = 0;

  virtual double t_start() const = 0;  ///< of the last step
  virtual double t() const = 0;
  virtual const Eigen::VectorXd& y() const = 0;
  /// State within the last step, cheaply.
  virtual void interpolate(double t, Eigen::VectorXd& y) = 0;
  /// The same to the accuracy of the steps.
  virtual void state_at(double t, Eigen::VectorXd& y) { interpolate(t, y); }
  /// Puts a corrected state in place of y(), within the tolerance of it.
  virtual void correct(const Eigen::VectorXd& y) = 0;
  /// Whether the other kind of method (explicit, implicit) would do better.
  virtual bool wants_change() const = 0;
  virtual double next_step() const = 0;

  const StepCounts& counts() const { return counts_; }

 protected:
  StepCounts counts_;
};

}  // namespace clevis::numerics
