#pragma once

#include <array>

#include "mechanism/force_elements/force_element.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// Points on two different bodies that a force acts between: `between`, `from`
/// and `to` [m, in the frames L of their bodies].
/// @throws Error S002–S010.
std::array<mechanism::ElementPoint, 2> read_points(StrictTable& table,
                                                   const Names& names);

}  // namespace clevis::scene
