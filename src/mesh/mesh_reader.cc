#include "mesh/mesh_reader.h"

#include "mesh/cells.h"
#include "mesh/exact_geometry.h"
#include "mesh/gate.h"
#include "mesh/gmsh_file.h"

namespace clevis::mesh {

PartMesh<3> read_part_mesh(const std::filesystem::path& file,
                           double length_unit) {
  const GmshFile content = read_gmsh_file(file);
  PartMesh<3> mesh = build_cells(content, length_unit);
  check_size(mesh, content.name);
  check_connected(mesh, content.name);
  put_on_cylinders(mesh, content.name);
  check_jacobians(mesh, content.name);
  return mesh;
}

}  // namespace clevis::mesh
