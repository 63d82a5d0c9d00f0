#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Times between instants that slides pass with a long way: a seat that travels
/// along a part stresses it at each place otherwise, even under loads that are
/// those of the instants before and behind [s].
/// @param slides   joints.
/// @param instants  of a motion, in the order of time.
std::vector<double> slide_times(const MechanismDefinition& definition,
                                const std::vector<int>& slides,
                                const std::vector<Instant>& instants);

}  // namespace clevis::mechanism
