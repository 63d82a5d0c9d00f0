#pragma once

#include <string>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::report {

/// Notes on how a motion came about, one sentence each: those on the
/// definition; drives that hardly turn before the motion ends, bodies that
/// hardly move or that outrun sound [m/s]; freedom that no drive fixes and that
/// was integrated, from which start; bodies that assembly moved far from their
/// placement, or that had none; a search for the largest loads that did not
/// come to its end; friction whose breakaway is in no load; those on force
/// elements.
std::vector<std::string> motion_notes(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion);

}  // namespace clevis::report
