#include "mesh/reading/mesh_reader.h"

#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mesh/gmsh/gmsh_file.h"
#include "mesh/gmsh/gmsh_reader.h"
#include "mesh/quality/mesh_validation.h"
#include "mesh/reading/cells.h"
#include "mesh/reading/extrude.h"
#include "mesh/rounds/cylinder_groups.h"
#include "mesh/rounds/exact_geometry.h"
#include "mesh/rounds/faceted_rounds.h"

namespace clevis::mesh {

namespace {

/// A plate is no thicker than it is wide: terms through the thickness do not
/// find what happens at the ends of a bar along z.
void require_plate(const GmshFile& file, double length_unit, double thickness) {
  Eigen::AlignedBox3d box;
  for (const auto& point : file.points) box.extend(point);
  const double width = length_unit * box.sizes().maxCoeff();
  if (thickness <= width) return;
  throw Error("M013", file.name,
              fmt::format("the `thickness` is {:.4g} mm, but the plate is only "
                          "{:.4g} mm wide",
                          1e3 * thickness, 1e3 * width),
              "Check thickness and length_unit; give a bar along z as a solid "
              "mesh.");
}

/// The file itself, or the plate whose mid-plane it holds.
GmshFile with_volume(GmshFile file, double length_unit,
                     std::optional<double> thickness) {
  if (!thickness) return file;
  if (is_flat(file)) {
    require_plate(file, length_unit, *thickness);
    return extrude(file, *thickness / length_unit);
  }
  throw Error("M013", file.name,
              "the part has a `thickness`, but its mesh is not flat",
              "Leave `thickness` out: it is for a mesh of triangles or "
              "quadrangles in a plane z = const.");
}

/// The mesh with the cylinders of its groups and those behind its facets; with
/// those of the groups alone if the others fold cells.
ReadMesh on_cylinders(PartMesh<3> mesh, const std::string& name) {
  fit_cylinder_groups(mesh, name);  // these are not looked at
  const auto rounds = faceted_rounds(mesh);
  if (!rounds.empty()) {
    PartMesh<3> rounded = mesh;
    put_on_cylinders(rounded, rounds);
    if (are_sound(rounded)) {
      ReadMesh read{std::move(rounded), {}};
      for (const FacetedRound& round : rounds)
        read.notes.push_back(text(round));
      return read;
    }
  }
  put_on_cylinders(mesh);
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
  check_connected(mesh, content.name);
  ReadMesh read = on_cylinders(std::move(mesh), content.name);
  check_shapes(read.mesh, content.name);
  return read;
}

PartMesh<3> read_part_mesh(const std::filesystem::path& file,
                           double length_unit,
                           std::optional<double> thickness) {
  return read_mesh_with_notes(file, length_unit, thickness).mesh;
}

}  // namespace clevis::mesh
