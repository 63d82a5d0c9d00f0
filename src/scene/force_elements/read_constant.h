#pragma once

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// Keys of a constant force. @throws Error S002–S011.
mechanism::ForceElement read_constant(StrictTable& table, const Names& names);

}  // namespace clevis::scene
