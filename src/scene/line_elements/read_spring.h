#pragma once

#include "scene/element_base/line_source.h"

namespace clevis::scene {

/// Keys of a spring. @throws Error S002–S011.
mechanism::LineLaw read_spring(const LineSource& source);

}  // namespace clevis::scene
