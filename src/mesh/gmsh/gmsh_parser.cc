#include "mesh/gmsh/gmsh_parser.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mesh/gmsh/gmsh_nodes.h"

namespace clevis::mesh {

void GmshParser::read_format() {
  cursor_.line();
  const std::string text(cursor_.line());
  int type = -1, data_size = 0;
  char version[16] = "";
  if (std::sscanf(text.c_str(), "%15s %d %d", version, &type, &data_size) !=
      3) {
    cursor_.fail("the line after $MeshFormat is not `version type size`");
  }
  section_.is_version_4 = std::string_view(version) == "4.1";
  if (!section_.is_version_4 && std::string_view(version) != "2.2" &&
      std::string_view(version) != "2") {
    throw Error("M001", cursor_.place(),
                fmt::format("the mesh has version {}", version),
                "Export it as gmsh version 2.2 or 4.1 "
                "(Mesh.MshFileVersion = 4.1).");
  }
  if ((type != 0 && type != 1) || data_size != 8) {
    throw Error("M001", cursor_.place(),
                fmt::format("file type {} with data size {}", type, data_size),
                "Export it as ASCII (type 0) or binary (type 1) with 8-byte "
                "numbers.");
  }
  if (type == 1) {
    cursor_.set_binary();
    if (cursor_.integer() != 1) {
      throw Error("M001", cursor_.place(),
                  "the binary mesh has the byte order of another machine",
                  "Export it on a little-endian machine or as ASCII.");
    }
  }
  section_.end("MeshFormat");
}

void GmshParser::read_physical_names() {
  const auto claimed = cursor_.text_integer();
  if (claimed < 0) cursor_.fail("the number of physical names is negative");
  const std::size_t count =
      cursor_.count(std::uint64_t(claimed), 6, "physical names");
  for (std::size_t i = 0; i < count; ++i) {
    const auto dim = cursor_.text_integer();
    const auto tag = cursor_.text_integer();
    const std::string_view rest = cursor_.line();
    const std::size_t open = rest.find('"'), close = rest.rfind('"');
    if (open == close || dim < 0 || dim > 3) {
      cursor_.fail("a physical name is not `dimension tag \"name\"`");
    }
    const std::size_t length = close - open - 1;
    constexpr std::size_t kLongest = 127;  // of the format
    if (length > kLongest) {
      cursor_.fail(
          fmt::format("a physical name has {} bytes, the format allows {}",
                      length, kLongest));
    }
    file_.physical_names[{int(dim), int(tag)}] =
        std::string(rest.substr(open + 1, length));
  }
  section_.end("PhysicalNames");
}

void GmshParser::read_entities() {
  std::array<std::uint64_t, 4> counts{};
  for (auto& count : counts) count = cursor_.size();
  for (int dim = 0; dim < 4; ++dim) {
    const std::size_t count =
        cursor_.count(counts[std::size_t(dim)], 8, "entities");
    for (std::size_t i = 0; i < count; ++i) {
      const int tag = cursor_.integer();
      for (int box = 0; box < (dim == 0 ? 3 : 6); ++box) cursor_.real();
      auto& physicals = entity_physicals_[{dim, tag}];
      const std::size_t named =
          cursor_.count(cursor_.size(), 2, "physical tags");
      for (std::size_t p = 0; p < named; ++p) {
        physicals.push_back(std::abs(cursor_.integer()));
      }
      if (named > 64) {
        cursor_.fail(fmt::format("an entity is in {} physical groups", named));
      }
      if (dim == 0) continue;
      const std::size_t bounding =
          cursor_.count(cursor_.size(), 2, "bounding entities");
      for (std::size_t b = 0; b < bounding; ++b) cursor_.integer();
    }
  }
  section_.end("Entities");
}

GmshFile GmshParser::parse() {
  std::optional<RawElements> elements;
  read_format();
  for (cursor_.skip_space(); cursor_.remaining() > 0; cursor_.skip_space()) {
    const std::string section(cursor_.line());
    if (section == "$PhysicalNames") {
      read_physical_names();
    } else if (section == "$Entities" && section_.is_version_4) {
      read_entities();
    } else if (section == "$Nodes") {
      if (seen_nodes_) cursor_.fail("there is a second $Nodes section");
      seen_nodes_ = true;
      read_nodes(section_, file_);
    } else if (section == "$Elements") {
      if (elements) cursor_.fail("there is a second $Elements section");
      elements = read_elements(section_, entity_physicals_);
    } else if (section.size() > 1 && section.size() < 64 && section[0] == '$' &&
               !section.starts_with("$End")) {
      cursor_.skip_behind("$End" + section.substr(1));
    } else {
      cursor_.fail("a section was expected here");
    }
  }
  if (!seen_nodes_ || !elements) {
    cursor_.fail(fmt::format("the file ends without {}",
                             seen_nodes_ ? "$Elements" : "$Nodes"));
  }
  sort_nodes(file_);
  resolve_elements(std::move(*elements), file_);
  return std::move(file_);
}

}  // namespace clevis::mesh
