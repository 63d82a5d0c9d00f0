#pragma once

#include <Eigen/Core>

#include "mechanism/dynamic_state/state_scales.h"
#include "mechanism/equations_of_motion/equations_of_motion.h"
#include "mechanism/equations_of_motion/projection.h"
#include "mechanism/equations_of_motion/state_tangents.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// The equations of motion of a mechanism with free coordinates as a system of
/// ordinary differential equations, in the states of StateLayout. Times [s].
class ForwardDynamics : public numerics::OdeSystem {
 public:
  /// @param definition, frame  outlive this; frame_at_centres().
  /// @param tolerance  error of positions over the mechanism's length [1].
  /// @param duration  in which errors of velocities move bodies [s].
  ForwardDynamics(const MechanismDefinition& definition,
                  const SolvingFrame& frame, double tolerance, double duration);

  int size() const override {
    return static_cast<int>(equations_.layout().size());
  }
  void rate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& rate) override;
  void error_weights(const Eigen::VectorXd& y,
                     Eigen::VectorXd& weights) const override;
  void scales(const Eigen::VectorXd& y, Eigen::VectorXd& scales) const override;
  Eigen::Index tangents(double t, const Eigen::VectorXd& y,
                        Eigen::MatrixXd& T) override {
    return tangents_.put(t, y, T);
  }
  /// Axes of each body.
  void to_axes(const Eigen::VectorXd& y,
               Eigen::Ref<Eigen::VectorXd> v) const override {
    equations_.layout().to_axes(y, v);
  }
  void from_axes(const Eigen::VectorXd& y,
                 Eigen::Ref<Eigen::VectorXd> v) const override {
    equations_.layout().from_axes(y, v);
  }
  void hold_tangents(double t, const Eigen::VectorXd& y) override;
  void release_tangents() override { loads_.release_tangents(); }
  /// Of springs, stops, servos and gas along lines.
  Eigen::Index efforts() const override { return loads_.efforts(); }
  void hold_efforts(const Eigen::VectorXd* given) override {
    loads_.hold_efforts(given);
  }
  void efforts_by_law(Eigen::VectorXd& efforts) const override {
    efforts = equations_.state().loads.efforts_by_law;
  }
  void effort_response(Eigen::Index k,
                       Eigen::Ref<Eigen::VectorXd> rate) override;

  EquationsOfMotion& equations() { return equations_; }
  Projection& projection() { return projection_; }
  const StateScales& state_scales() const { return scales_; }
  /// Takes note of a state of the motion for state_scales().
  /// @pre equations().solve() there, or of a state close to it.
  void note_speed(const Eigen::VectorXd& y);

 private:
  EquationsOfMotion equations_;
  AppliedLoads& loads_;  ///< of the equations
  StateScales scales_;
  Projection projection_;
  StateTangents tangents_;
  Eigen::VectorXd force_;  ///< on the unknowns [N]
};

}  // namespace clevis::mechanism
