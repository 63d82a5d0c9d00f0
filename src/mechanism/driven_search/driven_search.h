#pragma once

#include <vector>

#include "mechanism/driven_trajectory/driven_trajectory.h"
#include "mechanism/sampling/law_times.h"

namespace clevis::mechanism {

/// Finds when the loads of a motion that drives fix are largest or jump,
/// whatever its uniform instants.
///
/// It looks wherever the laws of drives and tables bend or may turn back, as
/// often as bodies turn, at every event of the force elements and between
/// those until the loads are smooth from look to look.
/// Source: docs/theory.md, "Instants".
class DrivenSearch {
 public:
  DrivenSearch(const MechanismDefinition& definition,
               const SimulationSettings& settings, DrivenMotion& motion);

  struct Found {
    std::vector<double> times;    ///< of instants, the uniform ones among them
    std::vector<double> repeats;  ///< Motion::repeats, among the times
    std::vector<double> bends;    ///< Motion::bends, among the times
    double followed_until{};      ///< Motion::followed_until [s]
    /// At those times; none if one is singular or a change point was passed.
    std::vector<Configuration> positions;
    std::vector<MotionEvent> events;
    LoadSearch search;
  };
  Found run();

 private:
  void mark_laws();
  bool beside_change_point(double t) const;
  std::vector<Configuration> positions_at(const std::vector<double>& times);

  const MechanismDefinition& definition_;
  const SimulationSettings& settings_;
  std::size_t most_looks_;
  std::vector<double> uniform_;
  LawTimes laws_;
  DrivenTrajectory trajectory_;
};

}  // namespace clevis::mechanism
