#pragma once

#include <memory>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "mechanism/definition/definition.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "mechanism/joint_space/joint_coordinates.h"
#include "mechanism/joint_space/tree_system.h"
#include "numerics/integrators/switching_integrator.h"

namespace clevis::mechanism {

/// Integrates ForwardDynamics: bodies of a tree that its joints alone hold in
/// the coordinates of these, others as they are. States are those of the
/// dynamics.
class MotionIntegrator : public numerics::Integrator {
 public:
  /// @param frame, dynamics  outlive this.
  MotionIntegrator(const MechanismDefinition& definition,
                   const SolvingFrame& frame, ForwardDynamics& dynamics,
                   numerics::IntegratorChoice choice);

  MotionIntegrator(const MotionIntegrator&) = delete;
  MotionIntegrator& operator=(const MotionIntegrator&) = delete;

  void restart(double t, const Eigen::VectorXd& y, double step) override;
  bool step(double limit) override;
  double t_start() const override { return active_->t_start(); }
  double t() const override { return active_->t(); }
  const Eigen::VectorXd& y() const override;
  void interpolate(double t, Eigen::VectorXd& y) override;
  void state_at(double t, Eigen::VectorXd& y) override;
  void correct(const Eigen::VectorXd& y) override;
  bool wants_change() const override { return false; }
  double next_step() const override { return active_->next_step(); }

  /// "DOP853", "Radau IIA", or both.
  std::string method() const;
  long implicit_steps() const;

 private:
  bool in_joints() const { return active_ != &bodies_; }
  bool differs_by_round_off(const Eigen::VectorXd& y);
  void count();

  ForwardDynamics& dynamics_;
  numerics::SwitchingIntegrator bodies_;
  std::optional<JointCoordinates> coordinates_;
  std::unique_ptr<TreeSystem> tree_;
  std::optional<numerics::SwitchingIntegrator> joints_;
  numerics::SwitchingIntegrator* active_;
  mutable Eigen::VectorXd y_;
  Eigen::VectorXd z_, scratch_;
};

}  // namespace clevis::mechanism
