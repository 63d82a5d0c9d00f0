#include "mesh/gmsh/gmsh_reader.h"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "base/messages/errors.h"
#include "mesh/gmsh/gmsh_parser.h"

namespace clevis::mesh {

GmshFile parse_gmsh(std::string_view bytes, const std::string& name) {
  constexpr std::string_view kMagic = "$MeshFormat";
  const std::string_view head = bytes.substr(0, bytes.find_first_of("\r\n"));
  if (head != kMagic) {
    throw Error("M001", name,
                bytes.empty() ? "the file is empty"
                              : "the file does not begin with $MeshFormat",
                "Give a .msh of version 2.2 or 4.1; clevis never runs a mesh "
                "file as a script.");
  }
  return GmshParser(bytes, name).parse();
}

GmshFile read_gmsh_file(const std::filesystem::path& path) {
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) {
    throw Error("I001", path.string(), "there is no such mesh file",
                "Check the path of the mesh, or build it with `clevis mesh` or "
                "`clevis check --mesh`.");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error("I001", path.string(), "is not a regular file",
                "Give the mesh's .msh file, not a folder or device.");
  }
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? std::streamoff(stream.tellg()) : -1;
  std::string bytes(std::size_t(std::max<std::streamoff>(size, 0)), '\0');
  stream.seekg(0);
  if (size < 0 || !stream.read(bytes.data(), size)) {
    throw Error("I001", path.string(), "the mesh file cannot be read",
                "Check its permissions.");
  }
  return parse_gmsh(bytes, path.string());
}

}  // namespace clevis::mesh
