#pragma once

#include <cstddef>

#include "report/picture/surface.h"
#include "report/text/json_node.h"

namespace clevis::report {

/// The surface of a part's view with its stress at one of its frames.
/// @throws Error I003.
Surface stored_surface(const JsonNode& view, std::size_t frame);

}  // namespace clevis::report
