#pragma once

#include <nlohmann/json.hpp>

#include "report/page/glb_buffer.h"
#include "report/text/json_node.h"

namespace clevis::report {

/// A part as a glTF mesh: positions in m in its own frame, colours of its
/// largest stress over all instants, from 0 to `largest` [MPa], and the stress
/// itself as the attribute _VON_MISES_MPA.
/// @param part  of view/part_NAME.json.
nlohmann::ordered_json glb_mesh(const JsonNode& part, double largest,
                                GlbBuffer& buffer);

/// Largest stress of a part over its surface and instants [MPa].
double largest_stress(const JsonNode& part);

}  // namespace clevis::report
