#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "mesh/gmsh/gmsh_element.h"

namespace clevis::mesh {

/// An element as the file has it; several records with the same nodes stand
/// for one element in several physical groups.
struct GmshElement {
  std::uint64_t tag{};
  const ElementType* type{};
  int physical{};            ///< tag of the physical group; 0: none
  std::size_t first_node{};  ///< into GmshFile::element_nodes
};

/// Contents of a .msh file, in the file's own unit; nodes and elements are
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

}  // namespace clevis::mesh
