#pragma once

#include <string>
#include <vector>

#include "mesh/cells/part_mesh.h"
#include "mesh/quality/cell_quality.h"

namespace clevis::mesh {

/// Quality of each cell: of hexahedra at Gauss points (degree + 2 per
/// direction) and at the faces, edges and corners; of tetrahedra everywhere
/// (SimplexQuality).
std::vector<CellQuality> cell_qualities(const PartMesh<3>& mesh);

/// Refuses a mesh that is smaller than 10 µm or larger than 100 m, or thinner
/// than 1 µm or a millionth of its size.
/// @throws Error M007.
void check_size(const PartMesh<3>& mesh, const std::string& file);

/// Refuses cells whose longest edge or diagonal is more than 5000 times the
/// shortest: the equations lose the part's stiffness in their round-off.
/// @throws Error M005.
void check_shapes(const PartMesh<3>& mesh, const std::string& file);

/// @throws Error M006 with the pieces and their volumes.
void check_connected(const PartMesh<3>& mesh, const std::string& file);

/// Whether no cell is inverted or folded.
bool are_sound(const PartMesh<3>& mesh);

/// @throws Error M005 with the number of bad cells and where the first are.
void check_jacobians(const PartMesh<3>& mesh, const std::string& file);

}  // namespace clevis::mesh
