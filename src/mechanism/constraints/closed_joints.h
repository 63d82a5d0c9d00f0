#pragma once

#include <string_view>

#include "mechanism/constraints/assembly.h"
#include "mechanism/constraints/constraint_system.h"

namespace clevis::mechanism {

/// Configuration nearest to the placement in which all joints are closed,
/// whatever the drives want.
/// @param tolerance  [m].
/// @throws Error K001 that lists the joints that stay open.
Configuration closed_joints(const MechanismDefinition& definition,
                            const SolvingFrame& frame, double tolerance);

/// @param closing  what could not be closed.
/// @throws Error K001, always.
[[noreturn]] void refuse_open(const MechanismDefinition& definition,
                              const OpenJoints& open, std::string_view closing);

}  // namespace clevis::mechanism
