#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "base/errors.h"
#include "mesh/gmsh/gmsh_parser.h"

namespace clevis::mesh {

const ElementType& GmshParser::element_type(int id) const {
  const ElementType* type = find_element_type(id);
  if (type == nullptr) {
    throw Error("M008", cursor_.place(),
                fmt::format("element type {} is not known", id),
                "Mesh the part with hexahedra of order 1-4 or tetrahedra.");
  }
  return *type;
}

void GmshParser::add_element(std::uint64_t tag, const ElementType& type,
                             int physical) {
  raw_.elements.push_back(
      {tag, &type, std::abs(physical), raw_.node_tags.size()});
  for (int n = 0; n < type.nodes; ++n) raw_.node_tags.push_back(next_tag());
}

void GmshParser::read_elements_2_text() {
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

void GmshParser::read_elements_2_binary() {
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

void GmshParser::read_elements_4() {
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

void GmshParser::read_elements() {
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

void GmshParser::resolve_elements() {
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
            "Export the mesh again from its source.");
      }
      file_.element_nodes.push_back(unsigned(index));
    }
  }
  file_.elements = std::move(raw_.elements);
}

}  // namespace clevis::mesh
