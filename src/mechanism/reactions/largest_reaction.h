#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Of a motion; moments over a length [N]. @param length  [m].
double largest_reaction(const Motion& motion, double length);

/// Of each joint the largest reaction of the motion on that one of its two
/// bodies which is loaded least: what is little beside it decides nothing. At
/// least the motion's round-off. @param length  [m].
std::vector<double> reactions_beside(const std::vector<JointDefinition>& joints,
                                     const Motion& motion, double length);

}  // namespace clevis::mechanism
