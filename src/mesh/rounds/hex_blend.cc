#include "mesh/rounds/hex_blend.h"

#include <Eigen/Dense>

#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/rounds/cylinder_fit.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Moves the nodes of one hexahedron onto the cylinders; works on
/// displacements D from its points X, lexicographic: corners as its vertices,
/// edges and faces on their cylinders, the rest by transfinite blending.
class HexBlend {
 public:
  HexBlend(const PartMesh<3>& mesh, const CylindricalEntities& round,
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
    Triple i = {(edge.from & 1) * last_, (edge.from >> 1 & 1) * last_,
                (edge.from >> 2 & 1) * last_};
    const auto axis = std::size_t(edge.axis);
    std::vector<double> t;
    std::vector<Vector3d> straight;
    for (i[axis] = 1; i[axis] < last_; ++i[axis]) {
      D_.col(at(i)) = between_ends(i, axis);
      t.push_back(nodes_[i[axis]]);
      straight.emplace_back(X_.col(at(i)) + D_.col(at(i)));
    }
    const auto round = round_.edges.find(std::minmax(from, to));
    if (round == round_.edges.end()) return;
    const auto points =
        round_edge(mesh_, round->second, from, to, t, straight, file_order_);
    for (i[axis] = 1; i[axis] < last_; ++i[axis]) {
      D_.col(at(i)) = points[std::size_t(i[axis] - 1)] - X_.col(at(i));
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
  const CylindricalEntities& round_;
  const Eigen::VectorXd& nodes_;
  int last_, file_order_;
  Matrix3Xd X_, D_;
};

}  // namespace

void blend_hexahedra(PartMesh<3>& mesh, const CylindricalEntities& round,
                     int file_order) {
  const Eigen::VectorXd nodes = gauss_lobatto(mesh.degree);
  HexBlend blend(mesh, round, nodes, file_order);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (round.touch(mesh.cells[c])) mesh.cell_points[c] = blend.move(int(c));
  }
}

}  // namespace clevis::mesh
