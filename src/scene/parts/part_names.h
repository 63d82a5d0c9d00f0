#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "part/part_definition.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// Refuses names by which two parts, or a part and the assembly, would write
/// files of the same name. @throws Error S008.
void require_own_files(std::vector<StrictTable>& tables,
                       const mechanism::MechanismDefinition& mechanism,
                       const std::vector<part::PartDefinition>& parts);

}  // namespace clevis::scene
