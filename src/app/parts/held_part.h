#pragma once

#include "app/scenes/load_scene.h"
#include "loads/parts/held_pins.h"
#include "part/part_definition.h"

namespace clevis::app {

/// Loads of a case that pins hold, where balance leaves their reactions open
/// shared by the part's compliance.
/// @throws Error as of case_loads(), F….
loads::SharedPins held_loads(const LoadedPart& part,
                             const part::LoadCaseDefinition& load_case);

}  // namespace clevis::app
