#pragma once

#include <cstdint>
#include <string_view>

#include "mesh/gmsh/cursor.h"

namespace clevis::mesh {

/// A .msh file at a place between its sections.
struct GmshSection {
  Cursor& cursor;
  bool is_version_4 = false;

  /// A tag as the format writes it: int in version 2, size_t in version 4.
  /// @throws Error M001 if it is negative.
  std::uint64_t next_tag();

  /// Passes the $End line of a section. @throws Error M001 if it is not there.
  void end(std::string_view name);
};

}  // namespace clevis::mesh
