#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/motion.h"
#include "mechanism/definition/time_limit.h"
#include "mechanism/dynamic_motion/dynamic_change_points.h"
#include "mechanism/dynamic_motion/dynamic_instants.h"
#include "mechanism/dynamic_motion/motion_guards.h"
#include "mechanism/events/event_finder.h"
#include "mechanism/events/impact_recorder.h"
#include "mechanism/events/reaction_peaks.h"
#include "mechanism/events/stick_slip.h"
#include "mechanism/integration/dynamic_model.h"
#include "mechanism/integration/energy_balance.h"
#include "mechanism/integration/law_breaks.h"
#include "mechanism/integration/motion_integrator.h"

namespace clevis::mechanism {

/// One run: integrates from event to event and samples. Times are in seconds
/// [s].
class DynamicRun {
 public:
  /// @param limit  outlives this. @param others  instants besides the uniform
  ///   ones.
  DynamicRun(const MechanismDefinition& definition,
             const SimulationSettings& settings, TimeLimit& limit,
             const std::vector<double>& others = {});

  Motion run();
  /// Lets the run look for the largest reactions.
  void watch() { peaks_.emplace(model_.equations); }
  const ReactionPeaks& peaks() const { return *peaks_; }
  /// See DynamicInstants.
  void refine(const Eigen::VectorXd& largest,
              const BesideChangePoints& beside) {
    instants_.refine(largest, beside);
  }

 private:
  void start();
  void communicate(double t);
  void go_on(double limit);
  void end_step(double limit);
  void pass(const EventFinder::Event& event);
  void pass_break(double t);
  void restart(double t);
  [[noreturn]] void refuse_crowded_events(double t);
  IntegrationSummary summary() const;

  DynamicModel model_;
  EquationsOfMotion& equations_;  ///< of the model
  Projection& projection_;        ///< likewise
  StickSlip stick_slip_;
  LawBreaks breaks_;
  DynamicChangePoints change_points_;
  MotionIntegrator integrator_;
  EnergyBalance energy_;
  MotionGuards guards_;
  DynamicInstants instants_;
  EventFinder events_;
  ImpactRecorder impacts_;
  std::optional<ReactionPeaks> peaks_;
  Eigen::VectorXd y_;
  Motion motion_;
};

}  // namespace clevis::mechanism
