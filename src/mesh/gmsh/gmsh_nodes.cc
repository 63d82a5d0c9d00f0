#include "mesh/gmsh/gmsh_nodes.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::mesh {
namespace {

void read_node(GmshSection& section, std::uint64_t tag, GmshFile& file) {
  Cursor& cursor = section.cursor;
  Eigen::Vector3d point;
  for (double& x : point) x = cursor.real();
  if (!point.allFinite()) {
    throw Error("M004", cursor.place(),
                fmt::format("node {} has the coordinates ({}, {}, {})", tag,
                            point.x(), point.y(), point.z()),
                "Repair the node or export the mesh again.");
  }
  file.node_tags.push_back(tag);
  file.points.push_back(point);
}

void read_nodes_2(GmshSection& section, GmshFile& file) {
  Cursor& cursor = section.cursor;
  const auto claimed = cursor.text_integer();
  if (claimed < 0) cursor.fail("the number of nodes is negative");
  if (cursor.binary()) cursor.line();
  const std::size_t count =
      cursor.count(std::uint64_t(claimed), cursor.binary() ? 28 : 8, "nodes");
  file.node_tags.reserve(count);
  file.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    read_node(section, section.next_tag(), file);
}

void read_nodes_4(GmshSection& section, GmshFile& file) {
  Cursor& cursor = section.cursor;
  const std::size_t least = cursor.binary() ? 32 : 8;
  const std::size_t blocks = cursor.count(cursor.size(), 4, "node blocks");
  const std::size_t total = cursor.count(cursor.size(), least, "nodes");
  cursor.size();
  cursor.size();
  file.node_tags.reserve(total);
  file.points.reserve(total);
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dim = cursor.integer();
    cursor.integer();
    const int parameters = cursor.integer() != 0 ? std::clamp(dim, 0, 3) : 0;
    const std::size_t count = cursor.count(cursor.size(), least, "nodes");
    std::vector<std::uint64_t> tags(count);
    for (auto& tag : tags) tag = cursor.size();
    for (const auto tag : tags) {
      read_node(section, tag, file);
      for (int p = 0; p < parameters; ++p) cursor.real();
    }
  }
  if (file.points.size() != total) {
    cursor.fail(fmt::format("{} nodes are announced but {} are there", total,
                            file.points.size()));
  }
}

}  // namespace

void read_nodes(GmshSection& section, GmshFile& file) {
  if (section.is_version_4) {
    read_nodes_4(section, file);
  } else {
    read_nodes_2(section, file);
  }
  section.end("Nodes");
}

void sort_nodes(GmshFile& file) {
  auto& tags = file.node_tags;
  if (!std::is_sorted(tags.begin(), tags.end())) {
    std::vector<std::size_t> order(tags.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
      return tags[a] < tags[b];
    });
    const auto old_tags = tags;
    const auto old_points = file.points;
    for (std::size_t i = 0; i < order.size(); ++i) {
      tags[i] = old_tags[order[i]];
      file.points[i] = old_points[order[i]];
    }
  }
  const auto twice = std::adjacent_find(tags.begin(), tags.end());
  if (twice != tags.end()) {
    throw Error("M002", file.name,
                fmt::format("node {} is there twice", *twice),
                "Export the mesh again from its source.");
  }
}

}  // namespace clevis::mesh
