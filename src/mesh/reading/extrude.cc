#include "mesh/reading/extrude.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::mesh {

namespace {

using F = ElementFamily;
using Eigen::Vector3d;

constexpr unsigned kUnused = ~0u;

std::span<const unsigned> nodes_of(const GmshFile& file,
                                   const GmshElement& element) {
  return {file.element_nodes.data() + element.first_node,
          std::size_t(element.type->nodes)};
}

/// The flat cells, each once; all of one type.
std::vector<const GmshElement*> flat_cells(const GmshFile& file) {
  std::vector<const GmshElement*> cells;
  std::map<std::string_view, int> types;
  std::set<std::vector<unsigned>> seen;
  for (const GmshElement& element : file.elements) {
    if (element.type->dim != 2) continue;
    const auto nodes = nodes_of(file, element);
    if (!seen.emplace(nodes.begin(), nodes.end()).second) continue;
    cells.push_back(&element);
    ++types[element.type->name];
  }
  const F family = cells.front()->type->family;
  if (types.size() == 1 && (family == F::kQuad || family == F::kTriangle)) {
    return cells;
  }
  std::string listed;
  for (const auto& [name, count] : types) {
    listed +=
        fmt::format("{}{} of type {}", listed.empty() ? "" : ", ", count, name);
  }
  const bool may_be_split = std::ranges::all_of(cells, [](const auto* cell) {
    return cell->type->family == F::kQuad || cell->type->family == F::kTriangle;
  });
  throw Error("M008", file.name, fmt::format("the mesh has {}", listed),
              std::string("Mesh the plate with quadrangles of one order from 1 "
                          "to 4, or with triangles of order 1 or 2.") +
                  (may_be_split
                       ? " `Mesh.RecombineAll = 1; Mesh.SubdivisionAlgorithm = "
                         "1;` in the .geo file leaves quadrangles alone."
                       : ""));
}

/// Builds the layer; a node of the flat mesh stands order + 1 times above
/// itself.
class Layer {
 public:
  Layer(const GmshFile& file, double thickness)
      : file_(file),
        cells_(flat_cells(file)),
        type_(*cells_.front()->type),
        order_(type_.order) {
    result_.name = file.name;
    for (const auto& [key, name] : file.physical_names) {
      if (key.first == 1) result_.physical_names[{2, key.second}] = name;
    }
    copy_nodes(thickness);
  }

  GmshFile build() {
    for (const GmshElement* cell : cells_) {
      const auto nodes = turned_up(*cell);
      check_overlap(*cell, nodes);
      if (type_.family == F::kQuad) {
        add_hexahedron(*cell, nodes);
      } else {
        add_tetrahedra(*cell, nodes);
      }
    }
    for (const GmshElement& element : file_.elements) {
      if (element.type->dim == 1) add_side(element);
    }
    return std::move(result_);
  }

 private:
  void copy_nodes(double thickness) {
    std::vector<bool> used(file_.points.size(), false);
    Eigen::AlignedBox3d box;
    for (const GmshElement* cell : cells_) {
      for (const unsigned node : nodes_of(file_, *cell)) {
        used[node] = true;
        box.extend(file_.points[node]);
      }
    }
    const Vector3d extent = box.sizes();
    if (!(extent.z() <= 1e-8 * extent.norm())) {
      throw Error("M013", file_.name,
                  fmt::format("the mesh has no volume elements, and its "
                              "surfaces are in no plane z = const: z goes from "
                              "{:.9g} to {:.9g}",
                              box.min().z(), box.max().z()),
                  "Mesh the plate in a plane parallel to x and y, or the part "
                  "with volume elements.");
    }
    foot_ = box.center().z() - 0.5 * thickness;
    step_ = thickness / order_;
    first_copy_.assign(file_.points.size(), kUnused);
    for (std::size_t node = 0; node < used.size(); ++node) {
      if (used[node]) first_copy_[node] = stack(file_.points[node]);
    }
  }

  /// Copies of a point from bottom to top; the number of the first.
  unsigned stack(const Vector3d& p) {
    const auto first = unsigned(result_.points.size());
    for (int layer = 0; layer <= order_; ++layer) {
      result_.node_tags.push_back(result_.points.size() + 1);
      result_.points.emplace_back(p.x(), p.y(), foot_ + layer * step_);
    }
    return first;
  }

  /// First copies of a cell's nodes, counter-clockwise from above; those of
  /// quadrangles complete and lexicographic, those of triangles 0 1 2 01 12 20.
  std::vector<unsigned> turned_up(const GmshElement& cell) {
    std::vector<unsigned> nodes;
    for (const unsigned node : nodes_of(file_, cell)) {
      nodes.push_back(first_copy_[node]);
    }
    const auto at = [&](std::size_t i) {
      return Eigen::Vector2d(result_.points[nodes[i]].head<2>());
    };
    const bool quad = type_.family == F::kQuad;
    const Eigen::Vector2d one = quad ? at(2) - at(0) : at(1) - at(0);
    const Eigen::Vector2d two = quad ? at(3) - at(1) : at(2) - at(0);
    const bool down = one.x() * two.y() - one.y() * two.x() < 0.0;
    if (!quad) {
      if (down) std::swap(nodes[1], nodes[2]);
      if (down && order_ == 2) std::swap(nodes[3], nodes[5]);
      return nodes;
    }
    if (type_.serendipity) nodes.push_back(stack(serendipity_middle(nodes)));
    const int n = order_ + 1;
    const auto order = quadrangle_node_order(order_);
    std::vector<unsigned> lexicographic(nodes.size());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const int i = order[a] % n, j = order[a] / n;
      lexicographic[std::size_t(down ? j + n * i : order[a])] = nodes[a];
    }
    return lexicographic;
  }

  Vector3d serendipity_middle(const std::vector<unsigned>& nodes) const {
    Vector3d middle = Vector3d::Zero();
    for (std::size_t a = 0; a < 8; ++a) {
      middle += (a < 4 ? -0.25 : 0.5) * result_.points[nodes[a]];
    }
    return middle;
  }

  /// Cells that are turned up run along a common edge in opposite directions,
  /// unless one is folded over the other.
  void check_overlap(const GmshElement& cell,
                     const std::vector<unsigned>& nodes) {
    const auto k = std::size_t(order_), n = k + 1;
    const std::vector<std::size_t> ring =
        type_.family == F::kQuad
            ? std::vector{std::size_t(0), k, n * n - 1, n * k}
            : std::vector<std::size_t>{0, 1, 2};
    for (std::size_t v = 0; v < ring.size(); ++v) {
      const std::pair edge(nodes[ring[v]], nodes[ring[(v + 1) % ring.size()]]);
      if (edges_.insert(edge).second) continue;
      throw Error("M005", fmt::format("{}, element {}", file_.name, cell.tag),
                  "it lies over its neighbour: one of the two is inverted",
                  "Repair the mesh there, or export it again from its source.");
    }
  }

  void add_element(int type, const GmshElement& from,
                   const std::vector<unsigned>& nodes) {
    result_.elements.push_back({from.tag, find_element_type(type),
                                from.type->dim == 1 ? from.physical : 0,
                                result_.element_nodes.size()});
    result_.element_nodes.insert(result_.element_nodes.end(), nodes.begin(),
                                 nodes.end());
  }

  void add_hexahedron(const GmshElement& cell,
                      const std::vector<unsigned>& nodes) {
    static constexpr std::array kTypes = {5, 12, 92, 93};
    const auto size = int(nodes.size());
    std::vector<unsigned> all;
    for (const int i : hexahedron_node_order(order_)) {
      all.push_back(nodes[std::size_t(i % size)] + unsigned(i / size));
    }
    add_element(kTypes[std::size_t(order_ - 1)], cell, all);
  }

  /// A corner of the flat cell at the bottom (0) or the top (1).
  struct Corner {
    std::size_t local{};
    int up{};
  };

  /// The three tetrahedra between the prism's corners in ascending order:
  /// every side is cut from its lower corner at the bottom to its higher one
  /// at the top, on both sides of it.
  void add_tetrahedra(const GmshElement& cell,
                      const std::vector<unsigned>& nodes) {
    std::array<std::size_t, 3> v = {0, 1, 2};
    std::sort(v.begin(), v.end(), [&](auto a, auto b) {
      return nodes[a] < nodes[b];
    });
    const bool even = (v[0] + 1) % 3 == v[1];
    for (std::size_t turn = 0; turn < 3; ++turn) {
      std::array<Corner, 4> corners;
      for (std::size_t c = 0; c < 4; ++c) {
        // Up one corner after the other, the last first.
        const bool up = c > 2 - turn;
        corners[c] = {v[up ? c - 1 : c], up ? 1 : 0};
      }
      // Bottom corners 0 … 2 − turn, then top corners 2 − turn … 2.
      if (even != (turn % 2 == 0)) std::swap(corners[0], corners[1]);
      add_tetrahedron(cell, nodes, corners);
    }
  }

  void add_tetrahedron(const GmshElement& cell,
                       const std::vector<unsigned>& nodes,
                       const std::array<Corner, 4>& corners) {
    static constexpr std::array<std::array<std::size_t, 2>, 6> kEdges = {
        {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}}};
    // Of edges 01 02 12, by the sum of their ends.
    static constexpr std::array<std::size_t, 4> kMiddle = {0, 3, 5, 4};
    std::vector<unsigned> all;
    for (const Corner& c : corners) {
      all.push_back(nodes[c.local] + unsigned(c.up * order_));
    }
    for (const auto& [from, to] : kEdges) {
      if (order_ == 1) break;
      const Corner &a = corners[from], &b = corners[to];
      const std::size_t sum = a.local + b.local;
      const std::size_t middle = a.local == b.local ? a.local : kMiddle[sum];
      all.push_back(nodes[middle] + unsigned(a.up + b.up));
    }
    add_element(order_ == 1 ? 4 : 11, cell, all);
  }

  /// The surface over a curve's element, by corners only.
  void add_side(const GmshElement& line) {
    const auto nodes = nodes_of(file_, line);
    const unsigned a = first_copy_[nodes[0]], b = first_copy_[nodes[1]];
    if (a == kUnused || b == kUnused) {
      throw Error("M002", fmt::format("{}, element {}", file_.name, line.tag),
                  "the line is no edge of a cell",
                  "Mesh surface and curves together.");
    }
    const auto top = unsigned(order_);
    if (type_.family == F::kQuad) {
      add_element(3, line, {a, b, b + top, a + top});
      return;
    }
    const auto [low, high] = std::minmax(a, b);
    add_element(2, line, {low, high, high + top});
    add_element(2, line, {low, high + top, low + top});
  }

  const GmshFile& file_;
  std::vector<const GmshElement*> cells_;
  const ElementType& type_;
  int order_;
  double foot_{}, step_{};
  std::vector<unsigned> first_copy_;
  std::set<std::pair<unsigned, unsigned>> edges_;
  GmshFile result_;
};

}  // namespace

bool is_flat(const GmshFile& file) {
  bool flat = false;
  for (const GmshElement& element : file.elements) {
    if (element.type->dim == 3) return false;
    flat = flat || element.type->dim == 2;
  }
  return flat;
}

GmshFile extrude(const GmshFile& file, double thickness) {
  return Layer(file, thickness).build();
}

}  // namespace clevis::mesh
