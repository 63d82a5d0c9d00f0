#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/change_points/rank_watch.h"
#include "mechanism/definition/motion.h"
#include "mechanism/dynamic_motion/initial_state.h"
#include "mechanism/dynamic_motion/watched_path.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "mechanism/reactions/equilibrium.h"

namespace clevis::mechanism {

/// Positions, rates, drives and elements of an integrated motion; no forces
/// but the elements'. @pre dynamics.rate() at this state and t [s].
/// @param accelerations  by slot, of M, in P [m/s²], [rad/s²].
Instant motion_at(const MechanismDefinition& definition,
                  const SolvingFrame& frame, const ForwardDynamics& dynamics,
                  double t, const std::vector<Twist>& accelerations);

/// The change points that an integrated motion passes. Times [s], states in the
/// units of ForwardDynamics.
class DynamicChangePoints {
 public:
  DynamicChangePoints(const MechanismDefinition& definition,
                      const SimulationSettings& settings,
                      const SolvingFrame& frame, ForwardDynamics& dynamics,
                      const Equilibrium& equilibrium)
      : definition_(definition),
        settings_(settings),
        frame_(frame),
        dynamics_(dynamics),
        equilibrium_(equilibrium),
        has_loops_(!frame.is_tree || !frame.couplings.empty()),
        path_(dynamics) {}

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
    std::vector<Twist> accelerations;
    /// Of joints that give way; nothing if these do not hold the loads.
    std::optional<Equilibrium::Solution> forces;
  };
  /// @return nothing where no regular branch leads on.
  std::optional<OnBranch> on_branch(double t, const Eigen::VectorXd& y);

  /// The change points found, each between the instants before and behind it.
  std::vector<ChangePoint> among(const std::vector<Instant>& instants) &&;

 private:
  void note_all(const std::vector<double>& zeros);
  void note(double t, Eigen::VectorXd& y);

  const MechanismDefinition& definition_;
  const SimulationSettings& settings_;
  const SolvingFrame& frame_;
  ForwardDynamics& dynamics_;
  const Equilibrium& equilibrium_;
  bool has_loops_;
  int freedom_{}, rank_{};
  double last_speed_{};  ///< ForwardDynamics::turning_speed() [1/s]
  std::optional<RankWatch> watch_;
  struct Candidate {
    double t{};
    Eigen::VectorXd state;
  };
  std::vector<Candidate> candidates_;  ///< that the watch awaits
  std::vector<ChangePoint> points_;
  WatchedPath path_;
  Eigen::VectorXd state_;
};

}  // namespace clevis::mechanism
