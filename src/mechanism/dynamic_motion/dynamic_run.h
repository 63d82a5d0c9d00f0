#pragma once

#include <optional>
#include <vector>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "mechanism/dynamic_motion/dynamic_change_points.h"
#include "mechanism/dynamic_motion/motion_integrator.h"
#include "mechanism/equations_of_motion/stick_slip.h"
#include "mechanism/events/event_finder.h"
#include "mechanism/events/impact_watch.h"
#include "mechanism/events/load_sampler.h"
#include "mechanism/events/reaction_peaks.h"
#include "mechanism/reactions/equilibrium.h"

namespace clevis::mechanism {

/// One run: integrates and samples. Times are in seconds [s].
class DynamicRun {
 public:
  /// @param others  instants besides the uniform ones.
  DynamicRun(const MechanismDefinition& definition,
             const SimulationSettings& settings,
             const std::vector<double>& others = {});

  Motion run();
  /// Lets the run look for the largest reactions.
  void watch() { peaks_.emplace(dynamics_); }
  const ReactionPeaks& peaks() const { return *peaks_; }
  /// Times beside change points, where rigid reactions have no largest.
  struct Beside {
    std::vector<double> change_points;
    double reach{};  ///< [s]
    bool contains(double t) const;
  };
  /// Lets the run add instants so that large loads change little between
  /// them, and on both sides of events.
  /// @param largest  ReactionPeaks::largest() [N²] or [N² m²].
  /// @param beside  times at which none is added.
  void refine(const Eigen::VectorXd& largest, const Beside& beside) {
    sampler_.emplace(dynamics_, largest);
    beside_ = beside;
  }

 private:
  void start();
  void find_breaks();
  double next_break() const;
  void pass(const EventFinder::Event& event);
  void pass_bend(double t);
  void restart(double t);
  void guard_against_accumulation(double t);
  void require_few(const numerics::StepCounts& counts) const;
  struct WeakestRows {
    bool beside = false;  ///< a change point
    Eigen::VectorXd row;  ///< combination of J's rows, of length 1
  };
  WeakestRows weakest_rows();
  bool is_beside_change_point();
  void refuse_dead_end();
  [[noreturn]] void refuse_stuck();
  void sample_until(double t);
  void state_at(double t, Eigen::VectorXd& y);
  bool misses_energy(double t, Eigen::VectorXd& y);
  void add_wanted(double until);
  void want_sides(double t);
  void add_instant(double t, Eigen::VectorXd& y);
  double energy_gap(const Eigen::VectorXd& y);
  void note_energy(const Eigen::VectorXd& y);
  void require_energy_balance() const;
  void require_closed(double t, double gap);
  void require_resisting_friction();

  const MechanismDefinition& definition_;
  const SimulationSettings& settings_;
  SolvingFrame frame_;
  ForwardDynamics dynamics_;
  StickSlip stick_slip_{dynamics_};
  Equilibrium equilibrium_;
  DynamicChangePoints change_points_;
  MotionIntegrator integrator_;
  MotionIntegrator resampler_;  ///< where dense output is too rough
  EventFinder events_;
  ImpactWatch impacts_;
  std::vector<double> sample_times_;
  Eigen::VectorXd y_, sample_, slope_;
  std::size_t next_sample_ = 0;
  std::optional<ReactionPeaks> peaks_;
  std::optional<LoadSampler> sampler_;
  Beside beside_;
  std::vector<double> wanted_;
  int two_sided_ = 0;
  Eigen::VectorXd event_values_;
  std::vector<DriveJump> jumps_;
  std::vector<double> breaks_;  ///< times at which drives or tables bend
  int crowded_events_ = 0;
  double last_event_ = -1.0;
  double energy_start_{}, energy_error_{}, largest_energy_{};
  double step_energy_error_{};  ///< at the ends of steps alone
  double largest_load_{};       ///< force on a body [N]
  Motion motion_;
};

}  // namespace clevis::mechanism
