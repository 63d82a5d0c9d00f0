#include "mesh/gmsh/gmsh_section.h"

#include <fmt/format.h>

namespace clevis::mesh {

void GmshSection::end(std::string_view name) {
  cursor.skip_space();
  if (cursor.line() != fmt::format("$End{}", name)) {
    cursor.fail(fmt::format(
        "$End{} was expected here: more or less stands in the section than "
        "its header announces",
        name));
  }
}

std::uint64_t GmshSection::next_tag() {
  if (is_version_4) return cursor.size();
  const int tag = cursor.integer();
  if (tag < 0) cursor.fail(fmt::format("tag {} is negative", tag));
  return std::uint64_t(tag);
}

}  // namespace clevis::mesh
