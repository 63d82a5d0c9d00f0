#pragma once

#include <string>
#include <vector>

#include "part/geometry_parameter.h"
#include "part/solid_source.h"

namespace clevis::part {

/// What a scene gives to a part's geometry: numbers to a .geo, and to a solid
/// which faces its groups are.
struct GeometryInput {
  std::vector<GeometryParameter> parameters;
  SolidSource solid;
};

}  // namespace clevis::part
