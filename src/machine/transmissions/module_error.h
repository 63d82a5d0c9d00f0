#pragma once

#include <optional>

namespace clevis::machine {

/// Contributions to the error of a module's output (5.77), on the output [rad]
/// or [m].
struct ErrorShares {
  double control{};    ///< of the control and the motor
  double kinematic{};  ///< of the gears
  double backlash{};   ///< whole lost motion
  double friction{};  ///< on the load [N m] or [N]; what reversal works against
};

/// Of the output; [rad] or [m].
struct ModuleError {
  ErrorShares shares;
  double compliance{};  ///< load × compliance
  double worst{};       ///< sum of the four
  double rss{};         ///< root of the sum of their squares
  /// Between the two directions of approach: backlash + 2 friction ×
  /// compliance.
  double reversal{};
  std::optional<double> reversal_run;  ///< the same by run_reversal()
};

/// @param load        on the output [N m] or [N].
/// @param compliance  of the output [rad/(N m)] or [m/N].
ModuleError module_error(const ErrorShares& shares, double load,
                         double compliance);

/// Motor and load joined by a spring with dead travel; the load slides
/// against dry friction. All seen from the output, which turns or slides:
/// inertias [kg m²] or [kg], compliance [rad/(N m)] or [m/N], backlash [rad]
/// or [m], friction [N m] or [N].
struct ReversalModel {
  double motor_inertia{}, load_inertia{};
  double compliance{}, backlash{};
  double friction{};  ///< > 0
};

/// Drives the motor there and back by a position servo and returns by how
/// much the load's distance from the motor differs between the two
/// directions, each after its start has died away [rad] or [m]; nothing if the
/// masses are so unequal that it would take more than 1e8 steps.
std::optional<double> run_reversal(const ReversalModel& model);

}  // namespace clevis::machine
