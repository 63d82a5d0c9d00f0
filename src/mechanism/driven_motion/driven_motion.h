#pragma once

#include <optional>
#include <vector>

#include "mechanism/definition/motion.h"
#include "mechanism/driven_motion/drive_path.h"
#include "mechanism/driven_motion/driven_change_points.h"
#include "mechanism/driven_motion/driven_instants.h"
#include "mechanism/driven_motion/driven_model.h"

namespace clevis::mechanism {

/// A motion that the drives fix, followed from its start. Times are in seconds
/// [s].
class DrivenMotion {
 public:
  /// @param definition, settings  outlive this.
  DrivenMotion(const MechanismDefinition& definition,
               const SimulationSettings& settings);

  /// @param times  increasing, from 0.
  Motion run_at(const std::vector<double>& times);
  /// Likewise through positions that were found before, which are not followed
  /// again.
  Motion run_through(const std::vector<double>& times,
                     const std::vector<Configuration>& positions);

  /// The first regular moment; what precedes it goes to `motion`.
  /// @throws Error as start_driven().
  DrivenMoment start(Motion& motion);
  /// From a regular moment to t, in steps of the drives' travel.
  /// @param singular  a time after `last` at which J has no full rank.
  void advance(DrivenMoment& last, std::optional<double>& singular, double t,
               Motion& motion);

  const DrivenModel& model() const { return model_; }
  DrivenInstants& instants() { return instants_; }

 private:
  Instant instant_at(const DrivenMoment& last, double t);

  const SimulationSettings& settings_;
  DrivenModel model_;
  DrivenInstants instants_;
  DrivenChangePoints change_points_;
  DrivePath path_;
};

}  // namespace clevis::mechanism
