#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/motion.h"
#include "mechanism/dynamic_motion/dynamic_change_points.h"
#include "mechanism/dynamic_motion/motion_guards.h"
#include "mechanism/events/load_sampler.h"
#include "mechanism/integration/dynamic_model.h"
#include "mechanism/integration/energy_balance.h"
#include "mechanism/integration/motion_integrator.h"

namespace clevis::mechanism {

/// Times beside change points, where rigid reactions have no largest.
struct BesideChangePoints {
  std::vector<double> times;  ///< of the change points [s]
  double reach{};             ///< [s]
  /// @param t  [s].
  bool contains(double t) const;
};

/// Instants of an integrated motion: when, and what they hold. Times [s].
class DynamicInstants {
 public:
  /// @param others  instants besides the uniform ones. All else is that of the
  ///   run, and outlives this.
  DynamicInstants(DynamicModel& model, DynamicChangePoints& change_points,
                  MotionIntegrator& integrator, EnergyBalance& energy,
                  MotionGuards& guards, const std::vector<double>& others);

  /// Lets instants be added so that large loads change little between them,
  /// and on both sides of events.
  /// @param largest  ReactionPeaks::largest() [N²] or [N² m²].
  /// @param beside  times at which none is added.
  void refine(const Eigen::VectorXd& largest, const BesideChangePoints& beside);
  /// The motion goes on from y.
  void restart(double t, const Eigen::VectorXd& y);
  /// Adds the times that the loads of the integrator's last step call for.
  void look(double until);
  /// Adds those just before and behind a time at which loads may jump.
  void want_sides(double t);
  /// Takes all instants up to t.
  void sample_until(double t);
  /// Takes one at t. @param y  the state there, which is projected.
  void add(double t, Eigen::VectorXd& y);
  /// State within the integrator's last step: by dense output, but beside a
  /// change point or in an impact, where that may be rough, by steps of its
  /// own.
  void state_at(double t, Eigen::VectorXd& y);

  std::vector<Instant>& instants() { return instants_; }
  /// Between them, where loads change by which only vibration is excited.
  std::vector<Instant>& repeats() { return repeats_; }
  /// Up to there instants and repeats follow all loads [s].
  double followed_until() const;
  /// LoadSampler::step_behind() [s].
  double step_behind() const;
  /// Evaluations that state_at() took beside the integrator's [1].
  long evaluations() const { return resampler_.counts().evaluations; }

 private:
  Instant instant_at(double t, Eigen::VectorXd& y);
  bool is_rough(double t, Eigen::VectorXd& y);

  DynamicModel& model_;
  DynamicChangePoints& change_points_;
  MotionIntegrator& integrator_;
  MotionIntegrator resampler_;  ///< where dense output is too rough
  EnergyBalance& energy_;
  MotionGuards& guards_;
  std::vector<double> times_, wanted_, followed_;
  std::vector<double> repeated_;  ///< of times_, those of repeats()
  std::size_t next_ = 0;          ///< of times_
  int two_sided_ = 0;
  std::optional<LoadSampler> sampler_;
  BesideChangePoints beside_;
  std::vector<Instant> instants_, repeats_;
  Eigen::VectorXd sample_;
};

}  // namespace clevis::mechanism
