#pragma once

#include <Eigen/Core>

#include "mechanism/dynamic_state/state_layout.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Sizes of the states of a motion, by its largest speed so far, and how far
/// they may err.
class StateScales {
 public:
  /// @param layout  outlives this.
  /// @param tolerance  error of positions over the mechanism's length [1].
  /// @param duration  in which errors of velocities move bodies [s].
  StateScales(const StateLayout& layout, double tolerance, double duration)
      : layout_(layout),
        tolerance_(tolerance),
        slowest_(layout.length() / duration) {}

  double tolerance() const { return tolerance_; }  ///< over length() [1]
  /// Largest speed of the unknowns so far [m/s]; 0 before the first.
  double largest_speed() const { return speed_; }
  /// The least that counts: by the mechanism's length in the duration [m/s].
  double slowest_speed() const { return slowest_; }
  /// Of velocities [m/s].
  double speed_scale() const {
    return speed_ > 0.0 ? speed_ : layout_.length();
  }

  /// Takes note of a state of the motion, and tells the forces which speeds
  /// are errors. @param accelerations  of the unknowns [m/s²].
  /// @param smallest_pivot  ConstrainedMass::smallest_pivot() [1].
  void note(const Eigen::VectorXd& y, const Eigen::VectorXd& accelerations,
            double smallest_pivot, ForceModel& forces);

  /// Sizes of states, see OdeSystem: [m], [m/s], SI.
  void put_scales(const Eigen::VectorXd& y, const ForceModel& forces,
                  Eigen::VectorXd& scales) const;
  /// Their inverse errors [1/m], [s/m], SI.
  void put_error_weights(const Eigen::VectorXd& y, const ForceModel& forces,
                         Eigen::VectorXd& weights) const;

 private:
  const StateLayout& layout_;
  double tolerance_, slowest_, speed_{};
  double lowest_pivot_ = 1.0;  ///< so far
};

}  // namespace clevis::mechanism
