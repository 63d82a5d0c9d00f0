#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "base/errors.h"
#include "mesh/gmsh/gmsh_parser.h"

namespace clevis::mesh {

void GmshParser::read_node(std::uint64_t tag) {
  Eigen::Vector3d point;
  for (double& x : point) x = cursor_.real();
  if (!point.allFinite()) {
    throw Error("M004", cursor_.place(),
                fmt::format("node {} has the coordinates ({}, {}, {})", tag,
                            point.x(), point.y(), point.z()),
                "Repair the node or export the mesh again.");
  }
  file_.node_tags.push_back(tag);
  file_.points.push_back(point);
}

void GmshParser::read_nodes_2() {
  const auto claimed = cursor_.text_integer();
  if (claimed < 0) cursor_.fail("the number of nodes is negative");
  if (cursor_.binary()) cursor_.line();
  const std::size_t count =
      cursor_.count(std::uint64_t(claimed), cursor_.binary() ? 28 : 8, "nodes");
  file_.node_tags.reserve(count);
  file_.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) read_node(next_tag());
}

void GmshParser::read_nodes_4() {
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

void GmshParser::read_nodes() {
  if (seen_nodes_) cursor_.fail("there is a second $Nodes section");
  seen_nodes_ = true;
  if (version_4_) {
    read_nodes_4();
  } else {
    read_nodes_2();
  }
  end_section("Nodes");
}

void GmshParser::sort_nodes() {
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
                "Export the mesh again from its source.");
  }
}

}  // namespace clevis::mesh
