#pragma once

#include "machine/transmissions/transmission.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// An element of a stage. @throws Error S010 if it turns where the stage does
/// not, or the other way round.
machine::CompliantElement read_compliance(StrictTable& table, bool angular);

}  // namespace clevis::scene
