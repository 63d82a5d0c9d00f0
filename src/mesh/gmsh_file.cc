#include "mesh/gmsh_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>

#include "base/errors.h"
#include "mesh/cursor.h"

namespace clevis::mesh {

namespace {

/// Elements before their nodes are looked up.
struct RawElements {
  std::vector<GmshElement> elements;
  std::vector<std::uint64_t> node_tags;
};

class Parser {
 public:
  Parser(std::string_view bytes, const std::string& name)
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

void Parser::read_format() {
  cursor_.line();
  const std::string text(cursor_.line());
  int type = -1, data_size = 0;
  char version[16] = "";
  if (std::sscanf(text.c_str(), "%15s %d %d", version, &type, &data_size) !=
      3) {
    cursor_.fail("the line after $MeshFormat is not `version type size`");
  }
  version_4_ = std::string_view(version) == "4.1";
  if (!version_4_ && std::string_view(version) != "2.2" &&
      std::string_view(version) != "2") {
    throw Error("M001", cursor_.place(),
                fmt::format("the mesh has version {}", version),
                "export it as gmsh version 2.2 or 4.1 "
                "(Mesh.MshFileVersion = 4.1)");
  }
  if ((type != 0 && type != 1) || data_size != 8) {
    throw Error("M001", cursor_.place(),
                fmt::format("file type {} with data size {}", type, data_size),
                "export it as ASCII (type 0) or binary (type 1) with 8-byte "
                "numbers");
  }
  if (type == 1) {
    cursor_.set_binary();
    if (cursor_.integer() != 1) {
      throw Error("M001", cursor_.place(),
                  "the binary mesh has the byte order of another machine",
                  "export it on a little-endian machine or as ASCII");
    }
  }
  end_section("MeshFormat");
}

void Parser::end_section(std::string_view name) {
  cursor_.skip_space();
  if (cursor_.line() != fmt::format("$End{}", name)) {
    cursor_.fail(fmt::format(
        "$End{} was expected here: more or less stands in the section than "
        "its header announces",
        name));
  }
}

void Parser::read_physical_names() {
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
    file_.physical_names[{int(dim), int(tag)}] =
        std::string(rest.substr(open + 1, close - open - 1));
  }
  end_section("PhysicalNames");
}

void Parser::read_entities() {
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
  end_section("Entities");
}

void Parser::read_node(std::uint64_t tag) {
  Eigen::Vector3d point;
  for (double& x : point) x = cursor_.real();
  if (!point.allFinite()) {
    throw Error("M004", cursor_.place(),
                fmt::format("node {} has the coordinates ({}, {}, {})", tag,
                            point.x(), point.y(), point.z()),
                "repair the node or export the mesh again");
  }
  file_.node_tags.push_back(tag);
  file_.points.push_back(point);
}

/// A tag as the format writes it: int in version 2, size_t in version 4.
std::uint64_t Parser::next_tag() {
  if (version_4_) return cursor_.size();
  const int tag = cursor_.integer();
  if (tag < 0) cursor_.fail(fmt::format("tag {} is negative", tag));
  return std::uint64_t(tag);
}

void Parser::read_nodes_2() {
  const auto claimed = cursor_.text_integer();
  if (claimed < 0) cursor_.fail("the number of nodes is negative");
  if (cursor_.binary()) cursor_.line();
  const std::size_t count =
      cursor_.count(std::uint64_t(claimed), cursor_.binary() ? 28 : 8, "nodes");
  file_.node_tags.reserve(count);
  file_.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) read_node(next_tag());
}

void Parser::read_nodes_4() {
  const std::size_t least = cursor_.binary() ? 32 : 8;
  const std::size_t blocks = cursor_.count(cursor_.size(), 4, "node blocks");
  const std::size_t total = cursor_.count(cursor_.size(), least, "nodes");
  cursor_.size();
  cursor_.size();
  file_.node_tags.reserve(total);
  file_.points.reserve(total);
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dim = cursor_.integer();
    cursor_.integer();
    const int parameters = cursor_.integer() != 0 ? std::clamp(dim, 0, 3) : 0;
    const std::size_t count = cursor_.count(cursor_.size(), least, "nodes");
    std::vector<std::uint64_t> tags(count);
    for (auto& tag : tags) tag = cursor_.size();
    for (const auto tag : tags) {
      read_node(tag);
      for (int p = 0; p < parameters; ++p) cursor_.real();
    }
  }
  if (file_.points.size() != total) {
    cursor_.fail(fmt::format("{} nodes are announced but {} are there", total,
                             file_.points.size()));
  }
}

void Parser::read_nodes() {
  if (seen_nodes_) cursor_.fail("there is a second $Nodes section");
  seen_nodes_ = true;
  if (version_4_) {
    read_nodes_4();
  } else {
    read_nodes_2();
  }
  end_section("Nodes");
}

const ElementType& Parser::element_type(int id) const {
  const ElementType* type = find_element_type(id);
  if (type == nullptr) {
    throw Error("M008", cursor_.place(),
                fmt::format("element type {} is not known", id),
                "mesh the part with hexahedra of order 1-4 or tetrahedra");
  }
  return *type;
}

void Parser::add_element(std::uint64_t tag, const ElementType& type,
                         int physical) {
  raw_.elements.push_back(
      {tag, &type, std::abs(physical), raw_.node_tags.size()});
  for (int n = 0; n < type.nodes; ++n) raw_.node_tags.push_back(next_tag());
}

void Parser::read_elements_2_text() {
  const auto claimed = cursor_.text_integer();
  if (claimed < 0) cursor_.fail("the number of elements is negative");
  const std::size_t count =
      cursor_.count(std::uint64_t(claimed), 8, "elements");
  raw_.elements.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t tag = next_tag();
    const ElementType& type = element_type(cursor_.integer());
    const int tags = cursor_.integer();
    int physical = 0;
    for (int t = 0; t < tags; ++t) {
      const int value = cursor_.integer();
      if (t == 0) physical = value;
    }
    add_element(tag, type, physical);
  }
}

void Parser::read_elements_2_binary() {
  const auto claimed = cursor_.text_integer();
  cursor_.line();
  if (claimed < 0) cursor_.fail("the number of elements is negative");
  const std::size_t total =
      cursor_.count(std::uint64_t(claimed), 8, "elements");
  raw_.elements.reserve(total);
  while (raw_.elements.size() < total) {
    const ElementType& type = element_type(cursor_.integer());
    const int count = cursor_.integer();
    const int tags = cursor_.integer();
    if (count < 1 || std::size_t(count) > total - raw_.elements.size() ||
        tags < 0) {
      cursor_.fail(
          fmt::format("a block of {} elements with {} tags", count, tags));
    }
    for (int i = 0; i < count; ++i) {
      const std::uint64_t tag = next_tag();
      int physical = 0;
      for (int t = 0; t < tags; ++t) {
        const int value = cursor_.integer();
        if (t == 0) physical = value;
      }
      add_element(tag, type, physical);
    }
  }
}

void Parser::read_elements_4() {
  const std::size_t blocks = cursor_.count(cursor_.size(), 4, "element blocks");
  const std::size_t total =
      cursor_.count(cursor_.size(), cursor_.binary() ? 16 : 4, "elements");
  cursor_.size();
  cursor_.size();
  raw_.elements.reserve(total);
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dim = cursor_.integer();
    const int entity = cursor_.integer();
    const ElementType& type = element_type(cursor_.integer());
    const std::size_t count =
        cursor_.count(cursor_.size(), cursor_.binary() ? 16 : 4, "elements");
    const auto& physicals = entity_physicals_[{dim, entity}];
    for (std::size_t i = 0; i < count; ++i) {
      add_element(next_tag(), type, physicals.empty() ? 0 : physicals[0]);
      const GmshElement element = raw_.elements.back();
      for (std::size_t p = 1; p < physicals.size(); ++p) {
        raw_.elements.push_back(element);
        raw_.elements.back().physical = physicals[p];
      }
    }
  }
}

void Parser::read_elements() {
  if (seen_elements_) cursor_.fail("there is a second $Elements section");
  seen_elements_ = true;
  if (version_4_) {
    read_elements_4();
  } else if (cursor_.binary()) {
    read_elements_2_binary();
  } else {
    read_elements_2_text();
  }
  end_section("Elements");
}

void Parser::sort_nodes() {
  auto& tags = file_.node_tags;
  if (!std::is_sorted(tags.begin(), tags.end())) {
    std::vector<std::size_t> order(tags.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
      return tags[a] < tags[b];
    });
    const auto old_tags = tags;
    const auto old_points = file_.points;
    for (std::size_t i = 0; i < order.size(); ++i) {
      tags[i] = old_tags[order[i]];
      file_.points[i] = old_points[order[i]];
    }
  }
  const auto twice = std::adjacent_find(tags.begin(), tags.end());
  if (twice != tags.end()) {
    throw Error("M002", file_.name,
                fmt::format("node {} is there twice", *twice),
                "export the mesh again from its source");
  }
}

void Parser::resolve_elements() {
  const auto& tags = file_.node_tags;
  const bool dense =
      !tags.empty() && tags.back() - tags.front() + 1 == tags.size();
  std::stable_sort(raw_.elements.begin(), raw_.elements.end(),
                   [](const auto& a, const auto& b) {
                     return a.tag < b.tag;
                   });
  for (GmshElement& element : raw_.elements) {
    const std::size_t first = element.first_node;
    element.first_node = file_.element_nodes.size();
    for (int n = 0; n < element.type->nodes; ++n) {
      const std::uint64_t tag = raw_.node_tags[first + std::size_t(n)];
      std::size_t index = tags.size();
      if (dense) {
        if (tag >= tags.front() && tag <= tags.back()) index = tag - tags[0];
      } else {
        const auto at = std::lower_bound(tags.begin(), tags.end(), tag);
        if (at != tags.end() && *at == tag)
          index = std::size_t(at - tags.begin());
      }
      if (index == tags.size()) {
        throw Error(
            "M002", fmt::format("{}, element {}", file_.name, element.tag),
            fmt::format("it refers to node {}, which does not exist", tag),
            "export the mesh again from its source");
      }
      file_.element_nodes.push_back(unsigned(index));
    }
  }
  file_.elements = std::move(raw_.elements);
}

GmshFile Parser::parse() {
  read_format();
  for (cursor_.skip_space(); cursor_.remaining() > 0; cursor_.skip_space()) {
    const std::string section(cursor_.line());
    if (section == "$PhysicalNames") {
      read_physical_names();
    } else if (section == "$Entities" && version_4_) {
      read_entities();
    } else if (section == "$Nodes") {
      read_nodes();
    } else if (section == "$Elements") {
      read_elements();
    } else if (section.size() > 1 && section.size() < 64 && section[0] == '$' &&
               !section.starts_with("$End")) {
      cursor_.skip_behind("$End" + section.substr(1));
    } else {
      cursor_.fail("a section was expected here");
    }
  }
  if (!seen_nodes_ || !seen_elements_) {
    cursor_.fail(fmt::format("the file ends without {}",
                             seen_nodes_ ? "$Elements" : "$Nodes"));
  }
  sort_nodes();
  resolve_elements();
  return std::move(file_);
}

}  // namespace

GmshFile parse_gmsh(std::string_view bytes, const std::string& name) {
  constexpr std::string_view kMagic = "$MeshFormat";
  const std::string_view head = bytes.substr(0, bytes.find_first_of("\r\n"));
  if (head != kMagic) {
    throw Error("M001", name,
                bytes.empty() ? "the file is empty"
                              : "the file does not begin with $MeshFormat",
                "give a .msh of version 2.2 or 4.1; clevis never runs a mesh "
                "file as a script");
  }
  return Parser(bytes, name).parse();
}

GmshFile read_gmsh_file(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) {
    throw Error("I001", path.string(), "there is no such mesh file",
                "check the path of the mesh, or build it with `clevis mesh`");
  }
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? std::streamoff(stream.tellg()) : -1;
  std::string bytes(std::size_t(std::max<std::streamoff>(size, 0)), '\0');
  stream.seekg(0);
  if (size < 0 || !stream.read(bytes.data(), size)) {
    throw Error("I001", path.string(), "the mesh file cannot be read",
                "check its permissions");
  }
  return parse_gmsh(bytes, path.string());
}

}  // namespace clevis::mesh
