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

}  // namespace clevis::mesh
