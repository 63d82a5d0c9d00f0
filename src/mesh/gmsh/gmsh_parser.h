#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/gmsh/cursor.h"
#include "mesh/gmsh/gmsh_file.h"

namespace clevis::mesh {

/// Elements before their nodes are looked up.
struct RawElements {
  std::vector<GmshElement> elements;
  std::vector<std::uint64_t> node_tags;
};

/// Reads the bytes of a .msh file section by section.
class GmshParser {
 public:
  GmshParser(std::string_view bytes, const std::string& name)
      : cursor_(bytes, name) {
    file_.name = name;
  }

  GmshFile parse();

 private:
  void read_format();
  void read_physical_names();
  void read_entities();
  void read_nodes();
  void read_nodes_2();
  void read_nodes_4();
  void read_node(std::uint64_t tag);
  void read_elements();
  void read_elements_2_text();
  void read_elements_2_binary();
  void read_elements_4();
  const ElementType& element_type(int id) const;
  std::uint64_t next_tag();
  void add_element(std::uint64_t tag, const ElementType& type, int physical);
  void end_section(std::string_view name);
  void sort_nodes();
  void resolve_elements();

  Cursor cursor_;
  GmshFile file_;
  RawElements raw_;
  bool version_4_ = false;
  bool seen_nodes_ = false, seen_elements_ = false;
  std::map<std::pair<int, int>, std::vector<int>> entity_physicals_;
};

}  // namespace clevis::mesh
