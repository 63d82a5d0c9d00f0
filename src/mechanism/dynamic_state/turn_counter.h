#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/dynamic_state/mechanism_state.h"
#include "mechanism/dynamic_state/state_layout.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Angles near the true ones, which say how often a joint has turned since the
/// last state that was accepted as part of the motion: in the plane the bodies'
/// own angles tell, in space the rates since then. Times [s], angles [rad].
class TurnCounter {
 public:
  /// @param frame, layout  outlive this.
  TurnCounter(const SolvingFrame& frame, const StateLayout& layout,
              const ForceModel& forces);

  /// Turns count from those of x. @param y  has the positions of x.
  void start(const Configuration& x, const Eigen::VectorXd& y);
  /// Puts the turns at t into a state, those of elements into the forces.
  void count(double t, const Eigen::VectorXd& y, MechanismState& state,
             ForceModel& forces) const;
  /// A state is part of the motion: turns go on from there.
  /// @param state  with its loads.
  void accept(double t, const Eigen::VectorXd& y, const MechanismState& state);
  /// Spatial: the angles of all joints are known at t, turns are counted from
  /// there.
  void anchor(double t, const Configuration& x);
  double accepted_at() const { return accepted_at_; }  ///< [s]

 private:
  double turned_since(std::size_t j, double t, const Eigen::VectorXd& y,
                      const MechanismState& state) const;

  struct Turn {
    double angle{}, rate{};  ///< [rad], [rad/s]
    double plane_angle{};    ///< planar, of StateLayout [rad]
  };
  /// An element on the angle of a joint in the plane.
  struct PlaneAngle {
    std::size_t element{}, joint{};
    double accepted{};  ///< as of accept() [rad]
  };
  const SolvingFrame& frame_;
  const StateLayout& layout_;
  std::vector<Turn> turns_;  ///< by joint, at accepted_at_
  std::vector<PlaneAngle> plane_angles_;
  double accepted_at_{};
};

}  // namespace clevis::mechanism
