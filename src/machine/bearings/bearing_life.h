#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "machine/bearings/bearing.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::machine {

/// Integrals of a load over the travelled angle, by trapezoids between the
/// instants.
struct TravelMean {
  double travel{};  ///< ∫ |ω| dt [rad]
  double mean{};    ///< (∫ P^p |ω| dt / travel)^(1/p) [N]; 0 without travel
};

/// @param every  takes each instant (1), or every second one and the last (2).
TravelMean travel_mean(const BearingDefinition& bearing,
                       std::span<const BearingInstant> history,
                       std::size_t every = 1);

/// Life and static safety of a bearing ([ISO281], [ISO76]).
/// @param geared  teeth press on the joint, and their force is not in the
///   history.
/// @pre at least two instants.
BearingResult judge_bearing(const BearingDefinition& bearing,
                            std::span<const BearingInstant> history,
                            bool geared = false);

/// All bearings of a mechanism over its motion.
std::vector<BearingResult> judge_bearings(
    const std::vector<BearingDefinition>& bearings,
    const mechanism::MechanismDefinition& mechanism,
    const mechanism::Motion& motion);

}  // namespace clevis::machine
