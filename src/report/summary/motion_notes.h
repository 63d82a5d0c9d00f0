#pragma once

#include <string>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::report {

/// Notes on how a motion came about, one sentence each: gravity that no
/// machine meets; bodies denser or lighter than any, or with their mass far
/// from their joints; drives that hardly turn before the motion ends; freedom
/// that no drive fixes and that was integrated, from which start; bodies that
/// assembly moved far from their placement, or that had none; a search for the
/// largest loads that did not come to its end; friction whose breakaway is in
/// no load.
std::vector<std::string> motion_notes(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion);

/// The same as lines of a table, "  note: …".
std::string note_lines(const std::vector<std::string>& notes);

}  // namespace clevis::report
