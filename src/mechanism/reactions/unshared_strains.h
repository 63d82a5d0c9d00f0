#pragma once

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// What strains parts between joints whose reactions equilibrium leaves open,
/// and is not in how these are shared. Spin counts where it pulls a link's
/// middle by more than a hundredth of the motion's largest reaction: m ω² d/8
/// of a bar, d from joint to joint [N].
/// @param motion  of the definition, whose open reactions are still marked.
/// @param length  over which moments count as forces [m].
UnsharedStrains unshared_strains(const MechanismDefinition& definition,
                                 const Motion& motion, double length);

}  // namespace clevis::mechanism
