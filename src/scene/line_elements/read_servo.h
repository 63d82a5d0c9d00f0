#pragma once

#include "scene/element_base/line_source.h"

namespace clevis::scene {

/// Keys of a servo. @throws Error S002–S011.
mechanism::LineLaw read_servo(const LineSource& source);

}  // namespace clevis::scene
