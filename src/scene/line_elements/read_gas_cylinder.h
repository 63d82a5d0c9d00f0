#pragma once

#include "scene/element_base/line_source.h"

namespace clevis::scene {

/// Keys of a gas cylinder. @throws Error S002–S011.
mechanism::LineLaw read_gas_cylinder(const LineSource& source);

}  // namespace clevis::scene
