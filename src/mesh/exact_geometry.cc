#include "mesh/exact_geometry.h"

#include <algorithm>
#include <map>
#include <set>

#include <Eigen/Dense>

#include "mesh/cylinder_fit.h"
#include "mesh/cylinder_groups.h"
#include "mesh/tangent_round.h"
#include "mesh/tensor_basis.h"
#include "mesh/topology.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Nearest point that lies on all the given cylinders.
Vector3d project_on_all(const PartMesh<3>& mesh, const std::set<int>& groups,
                        Vector3d p) {
  const int rounds = groups.size() > 1 ? 50 : 1;
  for (int round = 0; round < rounds; ++round) {
    for (const int g : groups) {
      p = project(*mesh.groups[std::size_t(g)].cylinder, p);
    }
  }
  return p;
}

using Edge = std::pair<unsigned, unsigned>;

/// Where the cylinders touch the mesh.
struct RoundEntities {
  std::map<unsigned, std::set<int>> vertices;
  std::map<Edge, std::set<int>> edges;
  std::map<std::pair<int, int>, int> faces;  ///< by cell and local face
};

RoundEntities find_round_entities(const PartMesh<3>& mesh) {
  RoundEntities round;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group < 0 || !mesh.groups[std::size_t(face.group)].cylinder) {
      continue;
    }
    round.faces[{face.cell, face.face}] = face.group;
    const auto cycle = face_cycle(mesh, face);
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      round.vertices[cycle[i]].insert(face.group);
      round.edges[std::minmax(cycle[i], cycle[(i + 1) % cycle.size()])].insert(
          face.group);
    }
  }
  return round;
}

/// Moves the nodes of one hexahedron; works on displacements D from its
/// points X, lexicographic.
class HexBlend {
 public:
  HexBlend(const PartMesh<3>& mesh, const RoundEntities& round,
           const Eigen::VectorXd& nodes, int file_order)
      : mesh_(mesh),
        round_(round),
        nodes_(nodes),
        last_(int(nodes.size()) - 1),
        file_order_(file_order) {}

  /// New points of the cell.
  Matrix3Xd move(int cell) {
    X_ = mesh_.cell_points[std::size_t(cell)];
    D_ = Matrix3Xd::Zero(3, X_.cols());
    const auto& vertices = mesh_.cells[std::size_t(cell)];
    for (int v = 0; v < 8; ++v) {
      const Index i = corner(v);
      D_.col(i) = mesh_.vertices[vertices[std::size_t(v)]] - X_.col(i);
    }
    for (const HexEdge& edge : hex_edges()) move_edge(vertices, edge);
    for (int face = 0; face < 6; ++face) {
      const auto group = round_.faces.find({cell, face});
      move_face(face,
                group == round_.faces.end()
                    ? nullptr
                    : &*mesh_.groups[std::size_t(group->second)].cylinder);
    }
    blend_interior();
    return X_ + D_;
  }

 private:
  using Triple = std::array<int, 3>;

  Index at(const Triple& i) const {
    return i[0] + (last_ + 1) * (i[1] + Index(last_ + 1) * i[2]);
  }
  Index corner(int v) const {
    return at({(v & 1) * last_, (v >> 1 & 1) * last_, (v >> 2 & 1) * last_});
  }
  /// Part of the linear interpolation along `axis` between the two ends.
  Vector3d between_ends(Triple i, std::size_t axis) const {
    const double t = nodes_[i[axis]];
    i[axis] = 0;
    const Index low = at(i);
    i[axis] = last_;
    return (1.0 - t) * D_.col(low) + t * D_.col(at(i));
  }

  void move_edge(const std::vector<unsigned>& vertices, const HexEdge& edge) {
    const unsigned from = vertices[std::size_t(edge.from)];
    const unsigned to = vertices[std::size_t(edge.to)];
    const auto round = round_.edges.find(std::minmax(from, to));
    Triple i = {(edge.from & 1) * last_, (edge.from >> 1 & 1) * last_,
                (edge.from >> 2 & 1) * last_};
    const auto axis = std::size_t(edge.axis);
    std::vector<Vector3d> screw, own;
    double apart = 0.0;
    for (i[axis] = 1; i[axis] < last_; ++i[axis]) {
      const Index q = at(i);
      D_.col(q) = between_ends(i, axis);
      if (round == round_.edges.end()) continue;
      const auto& groups = round->second;
      own.push_back(project_on_all(mesh_, groups, X_.col(q) + D_.col(q)));
      const Vector3d even =
          screw_line(*mesh_.groups[std::size_t(*groups.begin())].cylinder,
                     mesh_.vertices[from], mesh_.vertices[to], nodes_[i[axis]]);
      screw.push_back(groups.size() > 1 ? project_on_all(mesh_, groups, even)
                                        : even);
      apart = std::max(apart, (own.back() - screw.back()).norm());
    }
    if (round == round_.edges.end()) return;
    // Equal angles converge fastest; a curved edge of the file that is clearly
    // another curve (an oblique cut, say) keeps its own.
    const double length = (mesh_.vertices[from] - mesh_.vertices[to]).norm();
    const bool even = file_order_ == 1 || apart < 1e-2 * length;
    for (i[axis] = 1; i[axis] < last_; ++i[axis]) {
      const auto n = std::size_t(i[axis] - 1);
      D_.col(at(i)) = (even ? screw[n] : own[n]) - X_.col(at(i));
    }
  }

  void move_face(int face, const part::Bore* cylinder) {
    const auto normal = std::size_t(face / 2);
    const std::size_t u = (normal + 1) % 3, v = (normal + 2) % 3;
    Triple i{};
    i[normal] = (face % 2) * last_;
    for (i[u] = 1; i[u] < last_; ++i[u]) {
      for (i[v] = 1; i[v] < last_; ++i[v]) {
        const Index q = at(i);
        D_.col(q) = between_ends(i, u) + between_ends(i, v) - bilinear(i, u, v);
        if (cylinder == nullptr) continue;
        D_.col(q) = project(*cylinder, X_.col(q) + D_.col(q)) - X_.col(q);
      }
    }
  }

  /// Interpolation between the four edges at the ends of u and v.
  Vector3d bilinear(Triple i, std::size_t u, std::size_t v) const {
    const double t = nodes_[i[u]];
    i[u] = 0;
    const Vector3d low = between_ends(i, v);
    i[u] = last_;
    return (1.0 - t) * low + t * between_ends(i, v);
  }

  Vector3d trilinear(Triple i) const {
    const double t = nodes_[i[0]];
    i[0] = 0;
    const Vector3d low = bilinear(i, 1, 2);
    i[0] = last_;
    return (1.0 - t) * low + t * bilinear(i, 1, 2);
  }

  void blend_interior() {
    Triple i{};
    for (i[2] = 1; i[2] < last_; ++i[2]) {
      for (i[1] = 1; i[1] < last_; ++i[1]) {
        for (i[0] = 1; i[0] < last_; ++i[0]) {
          D_.col(at(i)) = between_ends(i, 0) + between_ends(i, 1) +
                          between_ends(i, 2) - bilinear(i, 0, 1) -
                          bilinear(i, 1, 2) - bilinear(i, 0, 2) + trilinear(i);
        }
      }
    }
  }

  const PartMesh<3>& mesh_;
  const RoundEntities& round_;
  const Eigen::VectorXd& nodes_;
  int last_, file_order_;
  Matrix3Xd X_, D_;
};

void elevate(PartMesh<3>& mesh, int degree) {
  const Eigen::MatrixXd up =
      lagrange(gauss_lobatto(mesh.degree), gauss_lobatto(degree)).value;
  for (auto& points : mesh.cell_points) {
    points = interpolate<3>(points, {&up, &up, &up});
  }
  mesh.degree = degree;
}

bool touches(const RoundEntities& round, const std::vector<unsigned>& cell) {
  return std::any_of(cell.begin(), cell.end(), [&](unsigned v) {
    return round.vertices.contains(v);
  });
}

}  // namespace

void put_on_cylinders(PartMesh<3>& mesh, const std::string& file) {
  fit_cylinder_groups(mesh, file);
  const RoundEntities round = find_round_entities(mesh);
  if (round.faces.empty()) return;
  for (const auto& [v, groups] : round.vertices) {
    mesh.vertices[v] = project_on_all(mesh, groups, mesh.vertices[v]);
  }
  if (mesh.shape == CellShape::kSimplex) {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      for (std::size_t v = 0; v < 4; ++v) {
        mesh.cell_points[c].col(Index(v)) = mesh.vertices[mesh.cells[c][v]];
      }
    }
    return;
  }
  const int file_order = mesh.degree;
  elevate(mesh, std::max(file_order, kCylinderDegree));
  const Eigen::VectorXd nodes = gauss_lobatto(mesh.degree);
  HexBlend blend(mesh, round, nodes, file_order);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (touches(round, mesh.cells[c])) {
      mesh.cell_points[c] = blend.move(int(c));
    }
  }
}

}  // namespace clevis::mesh
