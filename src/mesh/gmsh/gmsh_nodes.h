#pragma once

#include "mesh/gmsh/gmsh_file.h"
#include "mesh/gmsh/gmsh_section.h"

namespace clevis::mesh {

/// Appends the nodes of a $Nodes section, in the file's unit.
/// @throws Error M001 if it is damaged, M004 for coordinates that are not
///   finite.
void read_nodes(GmshSection& section, GmshFile& file);

/// Sorts nodes by their tags. @throws Error M002 if a tag is there twice.
void sort_nodes(GmshFile& file);

}  // namespace clevis::mesh
