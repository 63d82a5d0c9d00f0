#pragma once

#include <vector>

#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Sets the instants before and behind each point.
void bracket_by_instants(const std::vector<Instant>& instants,
                         std::vector<ChangePoint>& points);

}  // namespace clevis::mechanism
