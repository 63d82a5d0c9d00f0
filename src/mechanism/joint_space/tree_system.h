#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "mechanism/joint_space/articulated_bodies.h"
#include "mechanism/joint_space/joint_coordinates.h"
#include "mechanism/joint_space/tree_scales.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// The motion of ForwardDynamics in the coordinates of a tree's joints, where
/// these and drives alone hold the bodies.
///
/// State z: open coordinates and velocities of JointCoordinates, internal
/// states of forces [SI], the work of all forces and drives [J], driven
/// coordinates and velocities. These follow their laws; integrated beside the
/// motion, they make its steps resolve the laws, too: the work would be
/// integrated too coarsely else. Times [s].
class TreeSystem : public numerics::OdeSystem {
 public:
  /// @param dynamics, coordinates  outlive this.
  TreeSystem(const MechanismDefinition& definition, ForwardDynamics& dynamics,
             JointCoordinates& coordinates);

  /// Whether the rotors of motors go with coordinates.
  static bool can_follow(const JointCoordinates& coordinates,
                         const ForceModel& forces);

  int size() const override {
    return static_cast<int>(driven_index() + 2 * driven());
  }
  void rate(double t, const Eigen::VectorXd& z, Eigen::VectorXd& rate) override;
  void error_weights(const Eigen::VectorXd& z,
                     Eigen::VectorXd& weights) const override;
  void scales(const Eigen::VectorXd& z, Eigen::VectorXd& scales) const override;
  Eigen::Index tangents(double t, const Eigen::VectorXd& z,
                        Eigen::MatrixXd& T) override;
  void hold_tangents(double t, const Eigen::VectorXd& z) override;
  void release_tangents() override { loads_.release_tangents(); }
  Eigen::Index efforts() const override { return loads_.efforts(); }
  void hold_efforts(const Eigen::VectorXd* given) override {
    loads_.hold_efforts(given);
  }
  void efforts_by_law(Eigen::VectorXd& efforts) const override {
    efforts = acting_.efforts_by_law;
  }
  void effort_response(Eigen::Index k,
                       Eigen::Ref<Eigen::VectorXd> rate) override;

  /// A motion starts at y, a state of the dynamics.
  void start(double t, const Eigen::VectorXd& y, Eigen::VectorXd& z);
  /// z of a state y close to z.
  void read(double t, const Eigen::VectorXd& y, Eigen::VectorXd& z);
  /// y of z. What the dynamics say of y at t counts turns as z does.
  void expand(double t, const Eigen::VectorXd& z, Eigen::VectorXd& y);

 private:
  Eigen::Index velocity_index() const {
    return static_cast<Eigen::Index>(coordinates_.open_coordinates().size());
  }
  Eigen::Index open_velocities() const {
    return static_cast<Eigen::Index>(coordinates_.open_velocities().size());
  }
  Eigen::Index internal_index() const {
    return velocity_index() + open_velocities();
  }
  Eigen::Index work_index() const {
    return internal_index() + equations_.forces().internal_states();
  }
  Eigen::Index driven_index() const { return work_index() + 1; }
  Eigen::Index driven() const {
    return static_cast<Eigen::Index>(coordinates_.driven().size());
  }
  void place(double t, const Eigen::VectorXd& z);
  void put_open(const std::vector<double>& q, const std::vector<double>& u,
                Eigen::Ref<Eigen::VectorXd> z) const;
  void put_driven(const std::vector<double>& q, const std::vector<double>& u,
                  Eigen::Ref<Eigen::VectorXd> z) const;
  void count_turns();

  EquationsOfMotion& equations_;
  const StateScales& scales_;
  JointCoordinates& coordinates_;
  AppliedLoads& loads_;
  LoadState acting_;  ///< at the last state placed
  ArticulatedBodies bodies_;
  Configuration x_;
  std::vector<Twist> twists_, levers_;
  /// Of all joints, by coordinate and by velocity.
  std::vector<double> q_, u_, q_rate_, u_rate_, response_;
  std::vector<double> q_start_;
  TreeScales sizes_;  ///< as of start()
  /// Elements on angles, which count the turns of their coordinates.
  struct Counted {
    std::size_t element{};
    JointCoordinates::Measured at;
    double offset{};  ///< whole turns [rad]
  };
  std::vector<Counted> counted_;
  std::vector<double> turned_;  ///< by link, planar: since start() [rad]
  Eigen::VectorXd start_y_, internal_;
};

}  // namespace clevis::mechanism
