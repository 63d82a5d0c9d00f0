#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "mesh/reading/mesh_reader.h"
#include "support/source_dir.h"

namespace clevis::mesh {

inline std::filesystem::path data(const std::string& name) {
  return support::source_dir() / "tests/data/meshes" / name;
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A mesh in mm from tests/data/meshes.
inline PartMesh<3> read(const std::string& name) {
  return read_part_mesh(data(name), 1e-3);
}

inline int group_index(const PartMesh<3>& mesh, const std::string& name) {
  for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
    if (mesh.groups[g].name == name) return int(g);
  }
  return -2;
}

}  // namespace clevis::mesh
