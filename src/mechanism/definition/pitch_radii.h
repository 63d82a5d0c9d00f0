#pragma once

#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Of the pitch circles of wheels 1 and 2, of a rack its pinion's [m].
/// @pre the coupling has teeth.
std::vector<double> pitch_radii(const std::vector<JointDefinition>& joints,
                                const CouplingDefinition& coupling);

}  // namespace clevis::mechanism
