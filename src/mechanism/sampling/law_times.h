#pragma once

#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Times that the laws of drives, tables, servos and targets name themselves,
/// within a motion [s]. Sorted, each once.
struct LawTimes {
  /// Loads may jump there: a drive starts or ends, a table steps.
  std::vector<double> steps;
  /// Tables of forces bend there.
  std::vector<double> breakpoints;
  /// Splines change from one cubic to the next.
  std::vector<double> knots;
  /// Between them and all of the above no law turns back or changes its pace
  /// much: quarters of sines, the extremes of quintics, parts of splines.
  std::vector<double> looks;
  bool all = true;  ///< false: too many for it
};

/// @param duration  of the motion [s].
/// @param most  looks; beyond them those of the quickest sines are left out.
LawTimes law_times(const MechanismDefinition& definition, double duration,
                   double most);

/// Times at which laws bend without a step: breakpoints and knots, rising [s].
std::vector<double> bends_of_laws(const LawTimes& times);

/// Instants that steps and bends ask for: both sides of a step, as close as
/// kSides, and the time of a bend [s].
std::vector<double> instants_of_laws(const LawTimes& times, double duration);

}  // namespace clevis::mechanism
