#pragma once

#include "part/part_definition.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// A [[part.case]] table. @throws Error S002–S011.
part::LoadCaseDefinition read_case(StrictTable table);

}  // namespace clevis::scene
