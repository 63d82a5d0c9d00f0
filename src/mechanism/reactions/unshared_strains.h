#pragma once

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// What strains parts between joints whose reactions equilibrium leaves open,
/// and is not in how these are shared. Spin counts where half a link's pull
/// m ω² d/8, d from joint to joint, is more than a hundredth of the motion's
/// largest reaction [N].
/// @param motion  of the definition, whose open reactions are still marked.
UnsharedStrains unshared_strains(const MechanismDefinition& definition,
                                 const Motion& motion);

}  // namespace clevis::mechanism
