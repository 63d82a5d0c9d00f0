#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Reads a gmsh mesh (2.2 or 4.1, ASCII or binary) of hexahedra (orders 1-4)
/// or tetrahedra (1-2), validates it, puts bore_* and round_* groups on
/// their exact cylinders, and facets that stand for one though no group says so
/// (faceted_rounds), and elevates the geometry. A flat mesh of quadrangles
/// (1-4) or triangles (1-2) in a plane z = const is the mid-plane of a plate
/// and becomes one layer of such cells.
///
/// @param length_unit  metres per unit of the file.
/// @param thickness    of the plate whose mid-plane the file holds [m].
/// @throws Error M001–M009, M014, M013 if the thickness does not fit the mesh,
/// I001.
PartMesh<3> read_part_mesh(const std::filesystem::path& file,
                           double length_unit,
                           std::optional<double> thickness = {});

/// A mesh with notes on what the reader inferred from the file.
struct ReadMesh {
  PartMesh<3> mesh;
  std::vector<std::string> notes;  ///< facets taken for cylinders
};
/// @param length_unit, thickness  as of read_part_mesh() [m].
ReadMesh read_mesh_with_notes(const std::filesystem::path& file,
                              double length_unit,
                              std::optional<double> thickness = {});

/// The mid-plane of a mesh that is (to 1e-8 of its size) a plate extruded along
/// z with uniform thickness: same quads in every layer, straight normal edges.
/// Its groups are those that lie on the sides only, in the same order; a group
/// on top or bottom is left out. Nothing if the part is not such a plate.
///
/// Tetrahedra need no layers: where every face of the outside lies at the
/// bottom, at the top or upright between them, the triangles at the bottom are
/// the mid-plane's, and groups on the sides reach from bottom to top.
std::optional<PartMesh<2>> plate_mid_plane(const PartMesh<3>& mesh);

}  // namespace clevis::mesh
