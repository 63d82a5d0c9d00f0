#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/change_points/rank_loss_detector.h"
#include "mechanism/definition/motion.h"
#include "mechanism/integration/corrected_trajectory.h"
#include "mechanism/integration/dynamic_model.h"
#include "mechanism/integration/initial_state.h"

namespace clevis::mechanism {

/// Positions, rates, drives and elements of an integrated motion; no forces
/// but the elements'. Time t [s]. @param state  with its loads.
/// @param accelerations  by slot, of M, in P [m/s²], [rad/s²].
Instant motion_at(const MechanismDefinition& definition,
                  const SolvingFrame& frame, const MechanismState& state,
                  const ForceModel& forces, double t,
                  const std::vector<SpatialAcceleration>& accelerations);

/// The change points that an integrated motion passes. Times [s], states in the
/// units of StateLayout.
class DynamicChangePoints {
 public:
  /// @param model  outlives this.
  explicit DynamicChangePoints(DynamicModel& model)
      : model_(model),
        equations_(model.equations),
        has_loops_(!model.frame.is_tree || !model.frame.couplings.empty()),
        path_(model.equations, model.projection) {}

  /// @throws Error K005 if the motion starts at one and must stop there.
  void start(const InitialState& initial, const Eigen::VectorXd& y);
  /// Looks from the last time to `until` in the integrator's last step.
  /// @param end  the state there as the motion goes on from it, corrected.
  /// @throws Error K005.
  void look(numerics::Integrator& integrator, double until,
            const Eigen::VectorXd& end);
  /// The motion ends.
  void finish();
  /// The motion goes on from y.
  void restart(const Eigen::VectorXd& y) { path_.restart(y); }

  /// Rank of the Jacobian at general positions.
  int rank() const { return rank_; }
  /// Accelerations and forces at a change point, where J leaves them open.
  struct OnBranch {
    std::vector<SpatialAcceleration> accelerations;
    /// Of joints that give way; nothing if these do not hold the loads.
    std::optional<Equilibrium::Solution> forces;
  };
  /// @return nothing where no regular branch leads on.
  std::optional<OnBranch> on_branch(double t, const Eigen::VectorXd& y);

  /// The change points found, each between the instants before and behind it.
  std::vector<ChangePoint> among(const std::vector<Instant>& instants) &&;

 private:
  double turning_speed(const Eigen::VectorXd& y) const;
  void note_all(const std::vector<double>& zeros);
  void note(double t, Eigen::VectorXd& y);

  DynamicModel& model_;
  EquationsOfMotion& equations_;  ///< of the model
  bool has_loops_;
  int freedom_{}, rank_{};
  double last_speed_{};  ///< of an unknown over the length [1/s]
  std::optional<RankLossDetector> watch_;
  struct Candidate {
    double t{};
    Eigen::VectorXd state;
  };
  std::vector<Candidate> candidates_;  ///< that the watch awaits
  std::vector<ChangePoint> points_;
  CorrectedTrajectory path_;
  Eigen::VectorXd state_;
};

}  // namespace clevis::mechanism
