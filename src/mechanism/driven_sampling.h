#pragma once

#include <vector>

#include "mechanism/motion.h"

namespace clevis::mechanism {

/// Uniform instants of a motion, both ends included [s].
std::vector<double> uniform_times(const SimulationSettings& settings);

/// Apart enough to be two instants, over the duration.
inline constexpr double kApart = 1e-9;
/// So far apart are the instants on both sides of an event, where loads may
/// jump, over the duration; all others are farther apart.
inline constexpr double kSides = 4e-9;

/// Adds times to increasing ones, but those that are there already.
void add_times(const std::vector<double>& more, double duration,
               std::vector<double>& times);

/// Both sides of the times at which drives and tables bend, within a motion.
std::vector<double> sides_of_bends(const MechanismDefinition& definition,
                                   double duration);

/// Whether an element's law changes between two instants: a contact or stop
/// touches or lets go, dry friction turns.
bool changes_mode(const MechanismDefinition& definition, const Instant& a,
                  const Instant& b);

/// Times between the instants of a driven motion at which more are wanted:
/// where large loads change much, and at maxima once they don't.
/// @param spacing  of the uniform instants [s].
std::vector<double> wanted_times(const Motion& motion, double spacing);

}  // namespace clevis::mechanism
