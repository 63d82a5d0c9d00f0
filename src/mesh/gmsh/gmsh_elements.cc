#include "mesh/gmsh/gmsh_elements.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::mesh {
namespace {

const ElementType& next_type(GmshSection& section) {
  const int id = section.cursor.integer();
  const ElementType* type = find_element_type(id);
  if (type == nullptr) {
    throw Error("M008", section.cursor.place(),
                fmt::format("element type {} is not known", id),
                "Mesh the part with hexahedra of order 1-4 or tetrahedra.");
  }
  return *type;
}

void add_element(GmshSection& section, std::uint64_t tag,
                 const ElementType& type, int physical, RawElements& raw) {
  raw.elements.push_back(
      {tag, &type, std::abs(physical), raw.node_tags.size()});
  for (int n = 0; n < type.nodes; ++n)
    raw.node_tags.push_back(section.next_tag());
}

void read_elements_2_text(GmshSection& section, RawElements& raw) {
  Cursor& cursor = section.cursor;
  const auto claimed = cursor.text_integer();
  if (claimed < 0) cursor.fail("the number of elements is negative");
  const std::size_t count = cursor.count(std::uint64_t(claimed), 8, "elements");
  raw.elements.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t tag = section.next_tag();
    const ElementType& type = next_type(section);
    const int tags = cursor.integer();
    int physical = 0;
    for (int t = 0; t < tags; ++t) {
      const int value = cursor.integer();
      if (t == 0) physical = value;
    }
    add_element(section, tag, type, physical, raw);
  }
}

void read_elements_2_binary(GmshSection& section, RawElements& raw) {
  Cursor& cursor = section.cursor;
  const auto claimed = cursor.text_integer();
  cursor.line();
  if (claimed < 0) cursor.fail("the number of elements is negative");
  const std::size_t total = cursor.count(std::uint64_t(claimed), 8, "elements");
  raw.elements.reserve(total);
  while (raw.elements.size() < total) {
    const ElementType& type = next_type(section);
    const int count = cursor.integer();
    const int tags = cursor.integer();
    if (count < 1 || std::size_t(count) > total - raw.elements.size() ||
        tags < 0) {
      cursor.fail(
          fmt::format("a block of {} elements with {} tags", count, tags));
    }
    for (int i = 0; i < count; ++i) {
      const std::uint64_t tag = section.next_tag();
      int physical = 0;
      for (int t = 0; t < tags; ++t) {
        const int value = cursor.integer();
        if (t == 0) physical = value;
      }
      add_element(section, tag, type, physical, raw);
    }
  }
}

void read_elements_4(GmshSection& section, const EntityPhysicals& of_entity,
                     RawElements& raw) {
  Cursor& cursor = section.cursor;
  const std::vector<int> none;
  const std::size_t blocks = cursor.count(cursor.size(), 4, "element blocks");
  const std::size_t total =
      cursor.count(cursor.size(), cursor.binary() ? 16 : 4, "elements");
  cursor.size();
  cursor.size();
  raw.elements.reserve(total);
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dim = cursor.integer();
    const int entity = cursor.integer();
    const ElementType& type = next_type(section);
    const std::size_t count =
        cursor.count(cursor.size(), cursor.binary() ? 16 : 4, "elements");
    const auto found = of_entity.find({dim, entity});
    const auto& physicals = found == of_entity.end() ? none : found->second;
    for (std::size_t i = 0; i < count; ++i) {
      add_element(section, section.next_tag(), type,
                  physicals.empty() ? 0 : physicals[0], raw);
      const GmshElement element = raw.elements.back();
      for (std::size_t p = 1; p < physicals.size(); ++p) {
        raw.elements.push_back(element);
        raw.elements.back().physical = physicals[p];
      }
    }
  }
}

}  // namespace

RawElements read_elements(GmshSection& section,
                          const EntityPhysicals& of_entity) {
  RawElements raw;
  if (section.is_version_4) {
    read_elements_4(section, of_entity, raw);
  } else if (section.cursor.binary()) {
    read_elements_2_binary(section, raw);
  } else {
    read_elements_2_text(section, raw);
  }
  section.end("Elements");
  return raw;
}

void resolve_elements(RawElements raw, GmshFile& file) {
  const auto& tags = file.node_tags;
  const bool dense =
      !tags.empty() && tags.back() - tags.front() + 1 == tags.size();
  std::stable_sort(raw.elements.begin(), raw.elements.end(),
                   [](const auto& a, const auto& b) {
                     return a.tag < b.tag;
                   });
  for (GmshElement& element : raw.elements) {
    const std::size_t first = element.first_node;
    element.first_node = file.element_nodes.size();
    for (int n = 0; n < element.type->nodes; ++n) {
      const std::uint64_t tag = raw.node_tags[first + std::size_t(n)];
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
            "M002", fmt::format("{}, element {}", file.name, element.tag),
            fmt::format("it refers to node {}, which does not exist", tag),
            "Export the mesh again from its source.");
      }
      file.element_nodes.push_back(unsigned(index));
    }
  }
  file.elements = std::move(raw.elements);
}

}  // namespace clevis::mesh
