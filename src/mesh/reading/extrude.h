#pragma once

#include "mesh/gmsh/gmsh_file.h"

namespace clevis::mesh {

/// Whether the file has cells of dimension 2 and none of dimension 3.
bool is_flat(const GmshFile& file);

/// One layer of volume cells on both sides of a flat mesh in a plane
/// z = const: quadrangles become hexahedra of their own order, triangles three
/// tetrahedra each, which hold the same curved geometry; physical curves become
/// the physical surfaces above and below them.
///
/// @param thickness  along z, in the unit of the file.
/// @throws Error M005 if neighbouring cells overlap, M008 for a mix or other
///   cells, M013 if the nodes are not in such a plane.
GmshFile extrude(const GmshFile& file, double thickness);

}  // namespace clevis::mesh
