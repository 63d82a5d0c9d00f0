#pragma once

#include <string>
#include <string_view>

#include "mesh/gmsh/cursor.h"
#include "mesh/gmsh/gmsh_elements.h"
#include "mesh/gmsh/gmsh_file.h"
#include "mesh/gmsh/gmsh_section.h"

namespace clevis::mesh {

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

  Cursor cursor_;
  GmshSection section_{cursor_};
  GmshFile file_;
  bool seen_nodes_ = false;
  EntityPhysicals entity_physicals_;
};

}  // namespace clevis::mesh
