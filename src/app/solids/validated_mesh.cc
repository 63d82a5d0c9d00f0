#include "app/solids/validated_mesh.h"

#include <filesystem>
#include <fstream>

#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"
#include "part/solid_source.h"

namespace clevis::app {
namespace {

/// What is wrong with a mesh as the user knows it, who has its geometry alone:
/// no file in a temporary folder, no unit that a STEP file says itself.
Error of_geometry(const Error& error, const std::string& mesh,
                  const std::filesystem::path& geometry) {
  std::string place = error.place();
  if (place.starts_with(mesh)) {
    place.replace(0, mesh.size(), geometry.string());
  }
  const bool says_unit =
      part::is_solid_file(geometry) &&
      part::geometry_format(geometry) != part::GeometryFormat::kBrep;
  return Error(error.code(), place, error.problem(),
               error.code() == "M007" && says_unit
                   ? "Check the unit of lengths in the file, which `clevis "
                     "faces` prints, and export it again."
                   : error.remedy());
}

}  // namespace

mesh::ReadMesh validated_mesh(const std::string& text,
                              const part::PartDefinition& part) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / part.mesh.filename();
  std::ofstream(file, std::ios::binary) << text;
  try {
    return mesh::read_mesh_with_notes(file, part.length_unit, part.thickness);
  } catch (const Error& error) {
    throw of_geometry(error, file.string(), part.geometry);
  }
}

}  // namespace clevis::app
