#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include "mesh/part_mesh.h"

namespace clevis::mesh {

/// Reads a gmsh mesh (2.2 or 4.1, ASCII or binary) of hexahedra (orders 1-4)
/// or tetrahedra (1-2), runs the gate, puts bore_* and round_* groups on
/// their exact cylinders and elevates the geometry.
///
/// @param length_unit  metres per unit of the file.
/// @throws Error M001–M009, I001.
PartMesh<3> read_part_mesh(const std::filesystem::path& file,
                           double length_unit);

/// The mid-plane of a mesh that is (to 1e-8 of its size) a plate extruded along
/// z with uniform thickness: same quads in every layer, straight normal edges.
/// Its groups are those that lie on the sides only, in the same order; a group
/// on top or bottom is left out. Nothing if the part is not such a plate.
std::optional<PartMesh<2>> plate_mid_plane(const PartMesh<3>& mesh);

}  // namespace clevis::mesh
