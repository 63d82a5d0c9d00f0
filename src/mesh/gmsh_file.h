#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "mesh/gmsh_element.h"

namespace clevis::mesh {

/// An element as the file has it; several records with the same nodes stand
/// for one element in several physical groups.
struct GmshElement {
  std::uint64_t tag{};
  const ElementType* type{};
  int physical{};            ///< tag of the physical group; 0: none
  std::size_t first_node{};  ///< into GmshFile::element_nodes
};

/// What a .msh file holds, in the file's own unit; nodes and elements are
/// sorted by tag so that all variants of the format give the same.
struct GmshFile {
  std::string name;  ///< for messages
  std::vector<std::uint64_t> node_tags;
  std::vector<Eigen::Vector3d> points;
  std::vector<GmshElement> elements;
  std::vector<unsigned> element_nodes;  ///< indices into points
  /// Names of the physical groups by dimension and tag.
  std::map<std::pair<int, int>, std::string> physical_names;
};

/// Reads gmsh 2.2 and 4.1, ASCII and little-endian binary.
///
/// Nothing but numbers is interpreted, and no count is believed that the
/// rest of the file cannot hold.
/// @throws Error M001 if it is no such file, M002 if it is damaged, M004 for
///   a coordinate that is not finite, M008 for unknown elements, I001.
GmshFile read_gmsh_file(const std::filesystem::path& path);

/// The same from bytes that were read already.
GmshFile parse_gmsh(std::string_view bytes, const std::string& name);

}  // namespace clevis::mesh
