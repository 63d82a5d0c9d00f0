#pragma once

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// The frame in which a mechanism is solved with M of every body moved into
/// its centre of mass, so that the mass matrix is block diagonal.
SolvingFrame frame_at_centres(const MechanismDefinition& definition);

}  // namespace clevis::mechanism
