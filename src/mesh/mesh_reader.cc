#include "mesh/mesh_reader.h"

#include <utility>

#include "base/errors.h"
#include "mesh/cells.h"
#include "mesh/exact_geometry.h"
#include "mesh/extrude.h"
#include "mesh/faceted_rounds.h"
#include "mesh/gate.h"
#include "mesh/gmsh_file.h"

namespace clevis::mesh {

namespace {

/// The file itself, or the plate whose mid-plane it holds.
GmshFile with_volume(GmshFile file, double length_unit,
                     std::optional<double> thickness) {
  if (!thickness) return file;
  if (is_flat(file)) return extrude(file, *thickness / length_unit);
  throw Error("M013", file.name,
              "the part has a `thickness`, but its mesh is not flat",
              "leave `thickness` out: it is for a mesh of triangles or "
              "quadrangles in a plane z = const");
}

/// The mesh with the cylinders of its groups and those behind its facets; with
/// those of the groups alone if the others fold cells.
ReadMesh on_cylinders(PartMesh<3> mesh, const std::string& name) {
  const auto rounds = faceted_rounds(mesh);
  if (!rounds.empty()) {
    PartMesh<3> rounded = mesh;
    put_on_cylinders(rounded, name, rounds);
    if (are_sound(rounded)) {
      ReadMesh read{std::move(rounded), {}};
      for (const FacetedRound& round : rounds)
        read.notes.push_back(text(round));
      return read;
    }
  }
  put_on_cylinders(mesh, name);
  check_jacobians(mesh, name);
  return {std::move(mesh), {}};
}

}  // namespace

ReadMesh read_mesh_with_notes(const std::filesystem::path& file,
                              double length_unit,
                              std::optional<double> thickness) {
  const GmshFile content =
      with_volume(read_gmsh_file(file), length_unit, thickness);
  PartMesh<3> mesh = build_cells(content, length_unit);
  check_size(mesh, content.name);
  check_cells_apart(mesh, content.name);
  check_connected(mesh, content.name);
  return on_cylinders(std::move(mesh), content.name);
}

PartMesh<3> read_part_mesh(const std::filesystem::path& file,
                           double length_unit,
                           std::optional<double> thickness) {
  return read_mesh_with_notes(file, length_unit, thickness).mesh;
}

}  // namespace clevis::mesh
