#pragma once

#include <string>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::report {

/// Adds what tells of a wrong number of a force element: one that never acts; a
/// stop or contact that is deep inside what it presses on [m] or [rad]; a
/// spring stretched to many times the mechanism's size [m]; a force far off its
/// body [m]; friction that no surface has [1]; gas that is none any more [Pa],
/// [K].
void add_element_notes(const mechanism::MechanismDefinition& definition,
                       const mechanism::Motion& motion,
                       std::vector<std::string>& notes);

}  // namespace clevis::report
