#include "app/solids/validated_mesh.h"

#include <filesystem>
#include <fstream>

#include "app/processes/temporary_folder.h"

namespace clevis::app {

mesh::ReadMesh validated_mesh(const std::string& text,
                              const part::PartDefinition& part) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / part.mesh.filename();
  std::ofstream(file, std::ios::binary) << text;
  return mesh::read_mesh_with_notes(file, part.length_unit, part.thickness);
}

}  // namespace clevis::app
