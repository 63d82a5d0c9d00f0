#pragma once

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/dynamic_state/mechanism_state.h"

namespace clevis::mechanism {

/// q' = (0, half) q [1/s] of a quaternion x, y, z, w that turns at twice the
/// angular velocity `half` [rad/s].
inline Eigen::Vector4d quaternion_rate(const Eigen::Vector4d& q,
                                       const Eigen::Vector3d& half) {
  Eigen::Vector4d rate;
  rate.head<3>() = q.w() * half + half.cross(q.head<3>());
  rate.w() = -half.dot(q.head<3>());
  return rate;
}

/// Where a state of a motion by forces stands in one vector y: positions of the
/// bodies (planar: x, y, length × angle [m]; spatial: position [m] and
/// quaternion [1]), their velocities (unknowns of ConstraintSystem [m/s]),
/// internal states of forces [SI], the work of all forces since the start [J].
class StateLayout {
 public:
  using Index = Eigen::Index;

  /// @param frame  frame_at_centres(); outlives this.
  /// @param internal_states  number of those of forces [1].
  StateLayout(const SolvingFrame& frame, int internal_states);

  bool is_planar() const { return planar_; }
  double length() const { return length_; }  ///< of the links' order [m]
  Index bodies() const { return bodies_; }
  Index velocities() const { return velocities_; }  ///< number of them
  Index velocity_index() const { return positions_; }
  Index internal_index() const { return positions_ + velocities_; }
  Index work_index() const { return internal_index() + internal_states_; }
  Index size() const { return work_index() + 1; }
  /// Largest speed of an unknown [m/s].
  double largest_speed(const Eigen::VectorXd& y) const {
    return y.segment(positions_, velocities_).lpNorm<Eigen::Infinity>();
  }

  /// Bodies, twists and speeds of y; turns and joints are left as they are.
  void read(const Eigen::VectorXd& y, MechanismState& state) const;
  /// Angle of b against a about the axis of a planar joint [rad].
  double plane_angle(const JointModel& joint, const Eigen::VectorXd& y) const;
  void put_positions(const Configuration& x, Eigen::VectorXd& y) const;
  /// Position and velocity of one body.
  /// @param turned  planar: since y_before [rad].
  void put_body(std::size_t slot, const BodyPlacement& placement,
                const Twist& twist, const Eigen::VectorXd& y_before,
                double turned, Eigen::VectorXd& y) const;
  /// Moves positions by a displacement of the unknowns [m].
  void move(Eigen::VectorXd& y, const Eigen::VectorXd& change) const;

  /// Fills the rates of the positions [m/s], [1/s]. @param state  read() of y.
  void put_position_rates(const Eigen::VectorXd& y, const MechanismState& state,
                          Eigen::VectorXd& rates) const;
  /// How positions change as bodies move by unknowns [m], to first order.
  void put_displacement(const Eigen::VectorXd& y,
                        const Eigen::Ref<const Eigen::VectorXd>& unknowns,
                        Eigen::Ref<Eigen::VectorXd> change) const;
  /// A change v of the state y from the solving frame's axes to those of each
  /// body, and back.
  void to_axes(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> v) const;
  void from_axes(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> v) const;
  /// Adds a lever of a line, a unit force [1] with its moment [m] on a body, as
  /// a force on the unknowns.
  void add_lever(int slot, const SpatialForce& lever,
                 Eigen::VectorXd& force) const;

 private:
  enum class Axes { kOfBodies, kOfFrame };
  void turn(const Eigen::VectorXd& y, Axes to,
            Eigen::Ref<Eigen::VectorXd> v) const;

  const SolvingFrame& frame_;
  bool planar_;
  double length_;
  Index bodies_, positions_, velocities_, internal_states_;
};

}  // namespace clevis::mechanism
