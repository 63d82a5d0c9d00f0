#pragma once

#include <vector>

#include "machine/transmissions/transmission.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[transmission]] tables, which need no mechanism.
std::vector<machine::TransmissionDefinition> read_transmissions(
    StrictTable& root, Names& names);

}  // namespace clevis::scene
