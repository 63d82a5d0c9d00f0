#pragma once

#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Uniform instants of a motion, both ends included [s].
std::vector<double> uniform_times(const SimulationSettings& settings);

/// Apart enough to be two instants, over the duration.
inline constexpr double kApart = 1e-9;
/// So far apart are the instants on both sides of an event, where loads may
/// jump, over the duration; all others are farther apart.
inline constexpr double kSides = 4e-9;

/// Adds times to increasing ones, but those that are there already [s].
void add_times(const std::vector<double>& more, double duration,
               std::vector<double>& times);

}  // namespace clevis::mechanism
