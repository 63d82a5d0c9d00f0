#pragma once

#include <string>
#include <vector>

#include "part/geometry_parameter.h"
#include "part/solid_source.h"

namespace clevis::part {

/// What a scene gives to a part's geometry: numbers to a .geo, to a solid which
/// faces its groups are, and to the mesh how often its cells are cut.
struct GeometryInput {
  std::vector<GeometryParameter> parameters;
  SolidSource solid;
  int refine = 1;  ///< hexahedra into this many along each direction
};

}  // namespace clevis::part
