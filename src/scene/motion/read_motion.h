#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[marker]] tables. @throws Error S002–S011.
std::vector<mechanism::MarkerDefinition> read_markers(StrictTable& root,
                                                      Names& names);

/// The [simulation] table. @throws Error S002–S011.
mechanism::SimulationSettings read_simulation(StrictTable table);

}  // namespace clevis::scene
