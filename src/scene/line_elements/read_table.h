#pragma once

#include "scene/element_base/line_source.h"

namespace clevis::scene {

/// Keys of a table. @throws Error S002–S011.
mechanism::LineLaw read_table(const LineSource& source);

}  // namespace clevis::scene
