#pragma once

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// Keys of a bushing. @throws Error S002–S011.
mechanism::ForceElement read_bushing(StrictTable& table, const Names& names);

}  // namespace clevis::scene
