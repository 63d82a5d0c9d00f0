#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/definition.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/equations_of_motion/constrained_mass.h"
#include "mechanism/equations_of_motion/following_friction.h"
#include "mechanism/forces/applied_loads.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// The frame in which a mechanism is solved with M of every body moved into
/// its centre of mass, so that the mass matrix is block diagonal.
SolvingFrame frame_at_centres(const MechanismDefinition& definition);

/// q' = (0, half) q [1/s] of a quaternion x, y, z, w that turns at twice the
/// angular velocity `half` [rad/s].
inline Eigen::Vector4d quaternion_rate(const Eigen::Vector4d& q,
                                       const Eigen::Vector3d& half) {
  Eigen::Vector4d rate;
  rate.head<3>() = q.w() * half + half.cross(q.head<3>());
  rate.w() = -half.dot(q.head<3>());
  return rate;
}

/// Equations of motion of a mechanism with free coordinates.
///
/// State y: positions of the bodies (planar: x, y, length × angle [m]; spatial:
/// position [m] and quaternion [1]), their velocities (unknowns of the
/// constraint system, [m/s]), internal states of forces [SI], the work of all
/// forces since the start [J]. Times are in seconds [s].
/// Drives are constraints that move. The rotor of a motor adds an unknown, its
/// speed at the joint times the length, and the row that ties it to the joint;
/// it is no state.
class ForwardDynamics : public numerics::OdeSystem {
 public:
  /// @param frame  frame_at_centres(); outlives this.
  /// @param tolerance  error of positions over the mechanism's length.
  /// @param duration  in which errors of velocities move bodies [s].
  ForwardDynamics(const MechanismDefinition& definition,
                  const SolvingFrame& frame, double tolerance, double duration);

  int size() const override { return static_cast<int>(work_index()) + 1; }
  void rate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& rate) override;
  void error_weights(const Eigen::VectorXd& y,
                     Eigen::VectorXd& weights) const override;
  void scales(const Eigen::VectorXd& y, Eigen::VectorXd& scales) const override;

  /// Positions and velocities that joints and drives leave open, and internal
  /// states.
  Eigen::Index tangents(double t, const Eigen::VectorXd& y,
                        Eigen::MatrixXd& T) override;
  /// Axes of each body.
  void to_axes(const Eigen::VectorXd& y,
               Eigen::Ref<Eigen::VectorXd> v) const override {
    turn(y, v, true);
  }
  void from_axes(const Eigen::VectorXd& y,
                 Eigen::Ref<Eigen::VectorXd> v) const override {
    turn(y, v, false);
  }
  void hold_tangents(double t, const Eigen::VectorXd& y) override;
  void release_tangents() override { applied_.release_tangents(); }
  /// Of springs, stops, servos and gas along lines.
  Eigen::Index efforts() const override { return applied_.efforts(); }
  void hold_efforts(const Eigen::VectorXd* given) override {
    applied_.hold_efforts(given);
  }
  void efforts_by_law(Eigen::VectorXd& efforts) const override {
    efforts = applied_.efforts_by_law();
  }
  void effort_response(Eigen::Index k,
                       Eigen::Ref<Eigen::VectorXd> rate) override;
  /// The last rate() is not finite, as friction that follows a reaction jams.
  bool jams() const { return following_.jams(); }

  /// State of bodies at rest, from which turns count. @throws Error K009.
  Eigen::VectorXd start(const Configuration& x);
  void event_values(double t, const Eigen::VectorXd& y,
                    Eigen::VectorXd& values);
  /// The same; computes no accelerations unless efforts that hold lines count.
  void guard_values(double t, const Eigen::VectorXd& y,
                    Eigen::VectorXd& values);
  ForceModel& forces() { return forces_; }
  const ForceModel& forces() const { return forces_; }
  AppliedLoads& applied() { return applied_; }
  /// The forces alone, without what they make of the motion.
  void evaluate_forces(double t, const Eigen::VectorXd& y);
  /// Configuration, wrenches and Q of a state.
  void evaluate_loads(double t, const Eigen::VectorXd& y);
  /// The lever as a force on the unknowns, added to it.
  void put_lever(int slot, const Twist& lever, Eigen::VectorXd& force) const;
  /// Acceleration along a lever per force along it, were the body free.
  double free_response(int slot, const Twist& lever) const;
  /// Accelerations that a force on the unknowns adds, as of the last rate().
  void respond(const Eigen::VectorXd& force, Eigen::VectorXd& accelerations);
  /// Scale of the row that element k brings: 1, or the length of angles [m].
  double row_scale(std::size_t k) const {
    return forces_.is_angle(k) ? length_ : 1.0;
  }
  /// Orthonormal combinations of rows that vanish: what may be added to the
  /// multipliers, as of the last rate().
  Eigen::MatrixXd open_multipliers() const;
  /// By row, what drives ask of speeds and all rows of accelerations, as of
  /// the last rate().
  auto row_rates() const { return target_rates_.head(rows_); }
  auto row_accelerations() const { return gamma_.head(rows_); }
  const std::vector<DriveDefinition>& drives() const { return drives_; }
  /// F with F Fᵀ = length² inertia⁻¹, in L of the body of a slot.
  const Eigen::Matrix3d& turn_factor(std::size_t slot) const {
    return bodies_[slot].turn_factor;
  }
  /// Of the unknowns in the state of the last place() [m/s].
  const Eigen::VectorXd& speeds() const { return u_; }
  /// Largest of them so far, and the least that counts in the duration [m/s].
  double largest_speed() const { return speed_; }
  double slowest_speed() const { return slowest_; }

  /// Moves positions and velocities, by the least mass norm, onto the
  /// constraints at time t. @return the largest gap that is left [m].
  double project(double t, Eigen::VectorXd& y);

  /// The state of the last project(), y, is part of the motion: angles that
  /// count turns go on from there.
  void accept(double t, const Eigen::VectorXd& y);

  /// Drives follow from now on, at t itself too, what their laws say behind a
  /// bend at t.
  void enter_piece(double t) {
    piece_start_ = t;
    forces_.enter_piece(t);
  }
  /// Where drives jump: velocities change by the impulse that this takes,
  /// which does the work that is gained; dry friction has no part in it, its
  /// modes are to be chosen anew.
  void jump(double t, Eigen::VectorXd& y);

  /// When force elements communicate with the mechanism next [s].
  double next_communication() const { return forces_.next_communication(); }
  /// Lets the force elements communicate whose time has come.
  void communicate(double t, const Eigen::VectorXd& y);

  /// Configuration and twists of a state.
  void place(double t, const Eigen::VectorXd& y);
  /// The inverse, for a body. @param turned  planar: since y_before [rad].
  void put_body(std::size_t slot, const BodyPlacement& placement,
                const Twist& twist, const Eigen::VectorXd& y_before,
                double turned, Eigen::VectorXd& y) const;
  /// Spatial: the angles of all joints are known at t, turns are counted from
  /// there.
  void anchor_turns(double t, const Configuration& x);
  /// Whether nothing but joints, drives and rotors holds the bodies now.
  bool has_joints_alone() const;
  /// Coordinate, rate and acceleration that drive k prescribes at t.
  DriveTarget target(std::size_t k, double t) const;
  bool is_planar() const { return planar_; }

  /// As of the last place(), rate() or project().
  const Configuration& configuration() const { return x_; }
  /// The same with quaternions, which planar motions do without.
  Configuration whole_configuration() const;
  const std::vector<Twist>& twists() const { return twists_; }
  /// Of the unknowns [m/s²].
  const Eigen::VectorXd& accelerations() const { return acceleration_; }
  /// By row of system(), scaled as it is [N].
  const Eigen::VectorXd& multipliers() const { return lambda_; }
  const ConstrainedMass& mass() const { return mass_; }

  Eigen::Index velocity_index() const { return positions_; }
  Eigen::Index internal_index() const { return positions_ + system_.columns(); }
  Eigen::Index work_index() const {
    return internal_index() + forces_.internal_states();
  }
  /// Of joints and drives, without what sticks. @param J  is filled.
  void jacobian(double t, const Eigen::VectorXd& y, Eigen::MatrixXd& J);
  /// Motion on the branch of y's velocities at or beside a change point, where
  /// J leaves accelerations open.
  struct BranchMotion {
    Eigen::VectorXd accelerations;
    Eigen::MatrixXd open;  ///< columns: velocities that forces decide
  };
  /// @param freedom  of the joints elsewhere.
  /// @return nothing where no regular branch leads on.
  std::optional<BranchMotion> branch_motion(double t, const Eigen::VectorXd& y,
                                            int freedom);
  /// Of all bodies [J].
  double kinetic_energy(const Eigen::VectorXd& y);
  double length() const { return length_; }        ///< of the mechanism [m]
  double tolerance() const { return tolerance_; }  ///< over length() [1]
  /// Of unknowns, for scales() [m/s].
  double speed_scale() const { return speed_ > 0.0 ? speed_ : length_; }
  /// Fills the rates of the positions alone.
  void position_rates(double t, const Eigen::VectorXd& y,
                      Eigen::VectorXd& rates) {
    place(t, y);
    put_position_rates(y, rates);
  }
  /// Largest gap of joints and drives [m], turns × length.
  double gap(double t, const Eigen::VectorXd& y);
  /// Largest speed of an unknown over the length [1/s].
  double turning_speed(const Eigen::VectorXd& y) const {
    return y.segment(positions_, system_.columns()).lpNorm<Eigen::Infinity>() /
           length_;
  }
  /// Force on a body as of the last rate(), joints left out [N].
  double largest_load() const;
  const ConstraintSystem& system() const { return system_; }
  /// Largest speed of the unknowns so far, for error_weights() [m/s]; at least
  /// that which moves a body by the mechanism's length in the duration.
  void note_speed(const Eigen::VectorXd& y);

 private:
  void put_position_rates(const Eigen::VectorXd& y,
                          Eigen::VectorXd& rates) const;
  void set_targets(double t);
  void count_turns(double t, const Eigen::VectorXd& y);
  double turned_since(std::size_t j, double t, const Eigen::VectorXd& y) const;
  double plane_angle(const JointModel& joint, const Eigen::VectorXd& y) const;
  void factor();
  bool factor_tree();
  void add_loads(double t, const Eigen::VectorXd& y);
  std::vector<TreeLink> links() const;
  void place_rotors();
  /// Where sticking lines depend on one another: the multipliers at which the
  /// sum of squares of their efforts over their breakaways is least.
  void share_among_sticking();
  double correct_positions(double t, Eigen::VectorXd& y);
  void move(Eigen::VectorXd& y, const Eigen::VectorXd& change) const;
  void turn(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> v,
            bool to_bodies) const;
  void open_velocities(Eigen::MatrixXd& N);
  void put_displacement(const Eigen::VectorXd& y,
                        const Eigen::Ref<const Eigen::VectorXd>& unknowns,
                        Eigen::Ref<Eigen::VectorXd> change) const;

  struct Body {
    Eigen::Matrix3d inertia;      ///< about Cm, in L
    Eigen::Matrix3d turn_factor;  ///< in L: F with F Fᵀ = length² inertia⁻¹
    Eigen::Matrix3d turn_root;    ///< its inverse
    double inertia_z{};           ///< planar: about the normal
    Eigen::Matrix3d R_start;      ///< planar: orientation at angle zero
  };
  const SolvingFrame& frame_;
  const std::vector<DriveDefinition>& drives_;
  ConstraintSystem system_;
  AppliedLoads applied_;
  ForceModel& forces_;                ///< of them
  std::vector<Eigen::Index> rotors_;  ///< by force element: unknown, or −1
  Eigen::Index columns_;              ///< unknowns of bodies, then of rotors
  ConstrainedMass mass_;
  FollowingFriction following_;
  bool planar_;
  double length_, tolerance_, slowest_, speed_{};
  double lowest_pivot_ = 1.0;  ///< so far
  Eigen::Index positions_;
  std::vector<Body> bodies_;  ///< by slot
  struct Turn {
    double angle{}, rate{};  ///< [rad], [rad/s]
    double plane_angle{};    ///< planar, see plane_angle() [rad]
  };
  std::vector<Turn> turns_;  ///< by joint, at accepted_at_
  /// Elements on angles of joints in the plane, where bodies tell their turns.
  struct PlaneAngle {
    std::size_t element{}, joint{};
    double accepted{};  ///< as of accept() [rad]
  };
  std::vector<PlaneAngle> plane_angles_;
  double accepted_at_{};
  double piece_start_{};  ///< of the drives' laws [s]

  // workspace
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> row_space_;  ///< of tangents()
  Eigen::RowVectorXd row_workspace_;
  Eigen::MatrixXd open_;
  int rows_{};  ///< of the system and of force elements
  Eigen::VectorXd scratch_;
  Configuration x_;
  std::vector<PlacedJoint> placed_;
  std::vector<Twist> twists_;
  Eigen::MatrixXd J_;
  Eigen::VectorXd u_, targets_, target_rates_, target_seconds_, residual_,
      gamma_, Q_, acceleration_, lambda_, change_, response_, response_rows_;
};

}  // namespace clevis::mechanism
