#pragma once

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Every triangle cut into three quadrangles by its centre and the middles of
/// its sides: the same geometry (each piece is its parent's polynomial, of the
/// same degree along either direction), the same groups.
/// @pre triangles.
PartMesh<2> quadrangles_of(const PartMesh<2>& triangles);

}  // namespace clevis::mesh
