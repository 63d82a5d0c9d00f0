#pragma once

#include "mesh/cells/part_mesh.h"
#include "mesh/gmsh/gmsh_file.h"

namespace clevis::mesh {

/// The cells of a mesh file with its own geometry order, their outer faces
/// and the named groups; no cylinders yet. Hexahedra are turned so that the
/// edges that two cells share point the same way in both, where the mesh
/// allows it.
///
/// @param length_unit  of the file [m].
/// @throws Error M002 if faces do not fit the cells, M006 if a face has more
///   than two cells, M008 for cells that are not taken, M012 if a face is in
///   two named groups.
PartMesh<3> build_cells(const GmshFile& file, double length_unit);

}  // namespace clevis::mesh
