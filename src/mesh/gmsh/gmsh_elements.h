#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mesh/gmsh/gmsh_file.h"
#include "mesh/gmsh/gmsh_section.h"

namespace clevis::mesh {

/// Physical tags by dimension and tag of an entity of geometry.
using EntityPhysicals = std::map<std::pair<int, int>, std::vector<int>>;

/// Elements before their nodes are looked up.
struct RawElements {
  std::vector<GmshElement> elements;
  std::vector<std::uint64_t> node_tags;
};

/// Elements of an $Elements section; one in several physical groups is there
/// once for each.
/// @throws Error M001 if the section is damaged, M008 for types not known.
RawElements read_elements(GmshSection& section,
                          const EntityPhysicals& of_entity);

/// Takes elements over into the file in the order of their tags, with the
/// places of their nodes instead of tags.
/// @pre the file's nodes are sorted.
/// @throws Error M002 for a node that is not there.
void resolve_elements(RawElements raw, GmshFile& file);

}  // namespace clevis::mesh
