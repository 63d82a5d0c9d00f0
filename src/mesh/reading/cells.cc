#include "mesh/reading/cells.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <span>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/reading/orient.h"

namespace clevis::mesh {

namespace {

using F = ElementFamily;

constexpr std::string_view kRemedy =
    "Mesh the part with hexahedra of order 1-4, or with tetrahedra of order "
    "1-2.";

std::span<const unsigned> nodes_of(const GmshFile& file,
                                   const GmshElement& element) {
  return {file.element_nodes.data() + element.first_node,
          std::size_t(element.type->nodes)};
}

/// Volume elements as they come: the same one again stands for one in another
/// physical group, and nothing else.
class SeenVolumes {
 public:
  explicit SeenVolumes(const GmshFile& file) : file_(file) {}

  /// @return whether it is new.
  /// @throws Error M014 if it is there twice: in one group, or with its nodes
  ///   in another order.
  bool add(const GmshElement& element) {
    const auto nodes = nodes_of(file_, element);
    std::vector<unsigned> sorted(nodes.begin(), nodes.end());
    std::ranges::sort(sorted);
    const auto [entry, is_new] = seen_.try_emplace(std::move(sorted), &element);
    if (is_new) return true;
    const auto before = nodes_of(file_, *entry->second);
    if (std::ranges::equal(nodes, before) &&
        element.physical != entry->second->physical) {
      return false;
    }
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const unsigned node : nodes) middle += file_.points[node];
    middle /= double(nodes.size());
    throw Error("M014", file_.name,
                fmt::format("elements {} and {} near ({:.4g}, {:.4g}, {:.4g}) "
                            "are the same cell: the part would be twice as "
                            "stiff there",
                            entry->second->tag, element.tag, middle.x(),
                            middle.y(), middle.z()),
                "Mesh every volume once (gmsh: Coherence before Mesh 3).");
  }

 private:
  const GmshFile& file_;
  std::map<std::vector<unsigned>, const GmshElement*> seen_;
};

/// The volume elements, each once; all of one type.
std::vector<const GmshElement*> volume_elements(const GmshFile& file) {
  std::vector<const GmshElement*> volumes;
  std::map<std::string_view, std::size_t> types;
  SeenVolumes seen(file);
  for (const GmshElement& element : file.elements) {
    if (element.type->dim != 3 || !seen.add(element)) continue;
    volumes.push_back(&element);
    ++types[element.type->name];
  }
  if (volumes.empty()) {
    throw Error(
        "M008", file.name,
        "the mesh has no volume elements, only surfaces or lines",
        std::string(kRemedy) +
            " Check that the volume has a physical group; a plate's flat mesh "
            "needs the part's `thickness`.");
  }
  std::string listed;
  for (const auto& [name, count] : types) {
    listed +=
        fmt::format("{}{} of type {}", listed.empty() ? "" : ", ", count, name);
  }
  const F family = volumes.front()->type->family;
  if (types.size() > 1 ||
      (family != F::kHexahedron && family != F::kTetrahedron)) {
    throw Error("M008", file.name, fmt::format("the mesh has {}", listed),
                std::string(kRemedy));
  }
  return volumes;
}

/// Corner nodes of the file become vertices, in the order of their tags.
std::vector<unsigned> number_vertices(
    const GmshFile& file, const std::vector<const GmshElement*>& volumes,
    double length_unit, PartMesh<3>& mesh) {
  std::vector<unsigned> vertex(file.points.size(), kNoVertex);
  for (const GmshElement* element : volumes) {
    const auto corners =
        nodes_of(file, *element)
            .first(std::size_t(corner_count(element->type->family)));
    for (const unsigned node : corners) vertex[node] = 0;
  }
  for (std::size_t node = 0; node < vertex.size(); ++node) {
    if (vertex[node] == kNoVertex) continue;
    vertex[node] = unsigned(mesh.vertices.size());
    mesh.vertices.push_back(length_unit * file.points[node]);
  }
  return vertex;
}

void add_hexahedra(const GmshFile& file,
                   const std::vector<const GmshElement*>& volumes,
                   const std::vector<unsigned>& vertex, double length_unit,
                   PartMesh<3>& mesh) {
  static constexpr std::array<std::size_t, 8> kLexicographic = {0, 1, 3, 2,
                                                                4, 5, 7, 6};
  const ElementType& type = *volumes.front()->type;
  mesh.degree = type.order;
  const int n = type.order + 1;
  const auto order = hexahedron_node_order(type.order);
  const Eigen::VectorXd even = Eigen::VectorXd::LinSpaced(n, 0.0, 1.0);
  const Eigen::MatrixXd to_lobatto =
      lagrange(even, gauss_lobatto(type.order)).value;
  const Eigen::MatrixXd complete =
      type.serendipity ? serendipity_to_complete() : Eigen::MatrixXd();
  for (const GmshElement* element : volumes) {
    const auto nodes = nodes_of(file, *element);
    std::vector<unsigned> corners;
    for (const std::size_t local : kLexicographic) {
      corners.push_back(vertex[nodes[local]]);
    }
    Eigen::Matrix3Xd given(3, type.nodes);
    for (int a = 0; a < type.nodes; ++a) {
      given.col(a) = length_unit * file.points[nodes[std::size_t(a)]];
    }
    Eigen::Matrix3Xd points(3, n * n * n);
    if (type.serendipity) {
      points = given * complete.transpose();
    } else {
      for (int a = 0; a < type.nodes; ++a) {
        points.col(order[std::size_t(a)]) = given.col(a);
      }
    }
    // On orders 1 and 2 the even points are the Gauss–Lobatto points.
    if (type.order > 2) {
      points = interpolate<3>(points, {&to_lobatto, &to_lobatto, &to_lobatto});
    }
    mesh.cells.push_back(std::move(corners));
    mesh.cell_points.push_back(std::move(points));
  }
}

void add_tetrahedra(const GmshFile& file,
                    const std::vector<const GmshElement*>& volumes,
                    const std::vector<unsigned>& vertex, double length_unit,
                    PartMesh<3>& mesh) {
  const ElementType& type = *volumes.front()->type;
  mesh.shape = CellShape::kSimplex;
  mesh.degree = type.order;
  const auto order = tetrahedron_node_order(type.order);
  for (const GmshElement* element : volumes) {
    const auto nodes = nodes_of(file, *element);
    std::vector<unsigned> corners;
    for (std::size_t a = 0; a < 4; ++a) corners.push_back(vertex[nodes[a]]);
    Eigen::Matrix3Xd points(3, type.nodes);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      points.col(order[a]) = length_unit * file.points[nodes[a]];
    }
    mesh.cells.push_back(std::move(corners));
    mesh.cell_points.push_back(std::move(points));
  }
}

/// Index of each named surface group by physical tag; equal names are one.
std::map<int, int> name_groups(const GmshFile& file, PartMesh<3>& mesh) {
  std::map<int, int> index;
  for (const auto& [key, name] : file.physical_names) {
    if (key.first != 2) continue;
    const auto found = std::find_if(mesh.groups.begin(), mesh.groups.end(),
                                    [&](const auto& group) {
                                      return group.name == name;
                                    });
    index[key.second] = int(found - mesh.groups.begin());
    if (found == mesh.groups.end()) mesh.groups.push_back({name, {}});
  }
  return index;
}

/// Named surface elements by sorted corner vertices.
std::map<FaceVertices, int> named_faces(const GmshFile& file,
                                        const std::vector<unsigned>& vertex,
                                        const std::map<int, int>& group_index,
                                        const PartMesh<3>& mesh) {
  std::map<FaceVertices, int> named;
  for (const GmshElement& element : file.elements) {
    const auto group = group_index.find(element.physical);
    if (element.type->dim != 2 || group == group_index.end()) continue;
    const std::string& name = mesh.groups[std::size_t(group->second)].name;
    const int corners = corner_count(element.type->family);
    FaceVertices key;
    key.fill(kNoVertex);
    for (int a = 0; a < corners; ++a) {
      key[std::size_t(a)] = vertex[nodes_of(file, element)[std::size_t(a)]];
    }
    std::sort(key.begin(), key.end());
    const bool on_cells =
        corners == (mesh.shape == CellShape::kTensor ? 4 : 3) &&
        key[std::size_t(corners - 1)] != kNoVertex;
    if (!on_cells) {
      throw Error("M002", fmt::format("{}, element {}", file.name, element.tag),
                  fmt::format("the {} of group {} is no face of a cell",
                              element.type->name, name),
                  "Mesh surface and volume together.");
    }
    const auto [at, added] = named.try_emplace(key, group->second);
    if (!added && at->second != group->second) {
      throw Error(
          "M012", fmt::format("{}, element {}", file.name, element.tag),
          fmt::format("the face is in the groups {} and {}",
                      mesh.groups[std::size_t(at->second)].name, name),
          "Let every surface belong to one named physical group at most.");
    }
  }
  return named;
}

/// Keeps the names alone of groups without a face on the outside.
void drop_empty_groups(PartMesh<3>& mesh) {
  std::vector<int> faces(mesh.groups.size(), 0);
  for (const auto& face : mesh.boundary) {
    if (face.group >= 0) ++faces[std::size_t(face.group)];
  }
  std::vector<int> renumbered(mesh.groups.size(), -1);
  std::vector<SurfaceGroup> kept;
  for (std::size_t g = 0; g < faces.size(); ++g) {
    if (faces[g] == 0) {
      mesh.empty_groups.push_back(mesh.groups[g].name);
      continue;
    }
    renumbered[g] = int(kept.size());
    kept.push_back(mesh.groups[g]);
  }
  for (auto& face : mesh.boundary) {
    if (face.group >= 0) face.group = renumbered[std::size_t(face.group)];
  }
  mesh.groups = std::move(kept);
}

void add_boundary(const GmshFile& file, const std::vector<unsigned>& vertex,
                  PartMesh<3>& mesh) {
  const auto group_index = name_groups(file, mesh);
  const auto named = named_faces(file, vertex, group_index, mesh);
  const auto faces = sorted_faces(mesh);
  std::size_t found = 0;
  std::set<int> inner_groups;
  for (std::size_t i = 0, next; i < faces.size(); i = next) {
    for (next = i + 1;
         next < faces.size() && faces[next].corners == faces[i].corners;) {
      ++next;
    }
    if (next - i > 2) {
      throw Error("M006", file.name,
                  fmt::format("{} cells share one face", next - i),
                  "Remove the cells that overlap.");
    }
    const auto name = named.find(faces[i].corners);
    const int group = name == named.end() ? -1 : name->second;
    if (group >= 0) ++found;
    if (next - i == 1) {
      mesh.boundary.push_back({faces[i].cell, faces[i].face, group});
    } else if (group >= 0) {
      inner_groups.insert(group);
    }
  }
  if (found < named.size()) {
    throw Error("M002", file.name,
                fmt::format("{} faces of named groups are no faces of cells",
                            named.size() - found),
                "Mesh surface and volume together.");
  }
  for (const auto& face : mesh.boundary) {
    if (inner_groups.contains(face.group)) {
      throw Error("M002", file.name,
                  fmt::format("group {} lies partly inside the part",
                              mesh.groups[std::size_t(face.group)].name),
                  "Let a surface group hold faces of the outside only.");
    }
  }
  std::sort(mesh.boundary.begin(), mesh.boundary.end(),
            [](const auto& a, const auto& b) {
              return std::pair(a.cell, a.face) < std::pair(b.cell, b.face);
            });
  drop_empty_groups(mesh);
}

}  // namespace

PartMesh<3> build_cells(const GmshFile& file, double length_unit) {
  PartMesh<3> mesh;
  const auto volumes = volume_elements(file);
  const auto vertex = number_vertices(file, volumes, length_unit, mesh);
  if (volumes.front()->type->family == F::kHexahedron) {
    add_hexahedra(file, volumes, vertex, length_unit, mesh);
    orient_consistently(mesh);
  } else {
    add_tetrahedra(file, volumes, vertex, length_unit, mesh);
  }
  add_boundary(file, vertex, mesh);
  return mesh;
}

}  // namespace clevis::mesh
