#include "mesh/mesh_reader.h"

#include "base/errors.h"
#include "mesh/cells.h"
#include "mesh/exact_geometry.h"
#include "mesh/extrude.h"
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

}  // namespace

PartMesh<3> read_part_mesh(const std::filesystem::path& file,
                           double length_unit,
                           std::optional<double> thickness) {
  const GmshFile content =
      with_volume(read_gmsh_file(file), length_unit, thickness);
  PartMesh<3> mesh = build_cells(content, length_unit);
  check_size(mesh, content.name);
  check_connected(mesh, content.name);
  put_on_cylinders(mesh, content.name);
  check_jacobians(mesh, content.name);
  return mesh;
}

}  // namespace clevis::mesh
