#pragma once

#include <vector>

#include "part/geometry_parameter.h"
#include "scene/text/value.h"

namespace clevis::scene {

/// The numbers that a part gives to its .geo, by name. Texts with a unit of
/// length become numbers in the unit of the mesh; pure numbers are texts with
/// the unit 1.
/// @param length_unit  of the mesh's coordinates [m].
/// @throws Error S004, S005, S006.
std::vector<part::GeometryParameter> read_parameters(const Value& table,
                                                     double length_unit);

}  // namespace clevis::scene
