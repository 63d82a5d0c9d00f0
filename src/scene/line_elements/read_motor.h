#pragma once

#include "scene/element_base/line_source.h"

namespace clevis::scene {

/// Keys of a motor. @throws Error S002–S011.
mechanism::LineLaw read_motor(const LineSource& source);

}  // namespace clevis::scene
