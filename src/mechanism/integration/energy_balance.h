#pragma once

#include <Eigen/Core>

#include "mechanism/integration/dynamic_model.h"

namespace clevis::mechanism {

/// Kinetic energy [J] against the work of all forces [J], over a motion by
/// forces: what they differ by is the integration's error.
class EnergyBalance {
 public:
  /// @param model  outlives this.
  explicit EnergyBalance(DynamicModel& model) : model_(model) {}

  /// The motion starts at y.
  void start(const Eigen::VectorXd& y);
  /// Takes note of a state at which loads are evaluated.
  void note(const Eigen::VectorXd& y) { record(y); }
  /// Likewise, at the end of a step.
  void note_step(const Eigen::VectorXd& y);
  /// Whether a state within the last step has another energy than the ends of
  /// steps have: not than other instants within steps, of which many would
  /// loosen this.
  bool misses(const Eigen::VectorXd& y) const;
  /// They must agree: to a part of the largest of them, or to what the largest
  /// force does over the error of positions that is allowed.
  /// @throws Error K012.
  void require() const;

  double error() const { return error_; }  ///< largest difference [J]
  /// The same over the largest energy [1]; 0 where there is none.
  double relative_error() const {
    return largest_energy_ > 0.0 ? error_ / largest_energy_ : 0.0;
  }

 private:
  struct Energies {
    double kinetic{}, work{}, gap{};  ///< [J]
  };
  Energies energies(const Eigen::VectorXd& y) const;
  double record(const Eigen::VectorXd& y);

  DynamicModel& model_;
  double start_{}, error_{}, largest_energy_{};  ///< [J]
  double step_error_{};    ///< at the ends of steps alone [J]
  double largest_load_{};  ///< force on a body [N]
};

}  // namespace clevis::mechanism
