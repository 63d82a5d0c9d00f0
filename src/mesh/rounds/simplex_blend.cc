#include "mesh/rounds/simplex_blend.h"

#include <array>
#include <map>

#include <Eigen/Dense>

#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/rounds/cylinder_fit.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// How the movement of an edge's or face's inner nodes spreads over a
/// tetrahedron: (all nodes × inner nodes); the unit at these, zero on every
/// other edge or face, a polynomial of the cell's degree.
struct Spread {
  std::vector<int> vertices;  ///< local, of the edge or face
  std::vector<int> nodes;     ///< its inner nodes in the cell's lattice
  MatrixXd matrix;
};

class TetrahedronBlend {
 public:
  explicit TetrahedronBlend(int degree)
      : degree_(degree),
        lattice_(simplex_lattice<3>(degree)),
        barycentric_(4, Index(lattice_.size())) {
    barycentric_.bottomRows<3>() = simplex_nodes<3>(degree);
    barycentric_.row(0) =
        (1.0 - barycentric_.bottomRows<3>().colwise().sum().array()).matrix();
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) edges_.push_back(spread({a, b}));
    }
    for (int face = 0; face < 4; ++face) {
      const auto& v = simplex_face<3>(face);
      faces_.push_back(spread({v[0], v[1], v[2]}));
    }
  }

  /// New points of a cell.
  Matrix3Xd move(const PartMesh<3>& mesh, const CylindricalEntities& round,
                 int cell, int file_order) const {
    const Matrix3Xd& X = mesh.cell_points[std::size_t(cell)];
    const auto& vertices = mesh.cells[std::size_t(cell)];
    Matrix3Xd corners(3, 4);
    for (int v = 0; v < 4; ++v) {
      corners.col(v) =
          mesh.vertices[vertices[std::size_t(v)]] - X.col(corner(v));
    }
    Matrix3Xd points = X + corners * barycentric_;
    const Matrix3Xd straight = points;
    for (const Spread& edge : edges_) {
      const unsigned from = vertices[std::size_t(edge.vertices[0])];
      const unsigned to = vertices[std::size_t(edge.vertices[1])];
      const auto found = round.edges.find(std::minmax(from, to));
      if (found == round.edges.end() || edge.nodes.empty()) continue;
      std::vector<double> t;
      std::vector<Vector3d> along;
      for (const int node : edge.nodes) {
        t.push_back(barycentric_(edge.vertices[1], node));
        along.emplace_back(straight.col(node));
      }
      const auto target =
          round_edge(mesh, found->second, from, to, t, along, file_order);
      Matrix3Xd moved(3, Index(target.size()));
      for (std::size_t i = 0; i < target.size(); ++i) {
        moved.col(Index(i)) = target[i] - along[i];
      }
      points += moved * edge.matrix.transpose();
    }
    for (int face = 0; face < 4; ++face) {
      const Spread& spread = faces_[std::size_t(face)];
      const auto group = round.faces.find({cell, face});
      if (group == round.faces.end() || spread.nodes.empty()) continue;
      const auto& cylinder = *mesh.groups[std::size_t(group->second)].cylinder;
      Matrix3Xd moved(3, Index(spread.nodes.size()));
      for (std::size_t i = 0; i < spread.nodes.size(); ++i) {
        const Vector3d p = points.col(spread.nodes[i]);
        moved.col(Index(i)) = project(cylinder, p) - p;
      }
      points += moved * spread.matrix.transpose();
    }
    return points;
  }

 private:
  Index corner(int vertex) const {
    Index at = 0;
    while (lattice_[std::size_t(at)][std::size_t(vertex)] != degree_) ++at;
    return at;
  }

  /// Polynomials of the degree that is left once the product of the vertices'
  /// barycentric coordinates is divided out, at the cell's nodes; beside the
  /// edge or face these coordinates are raised evenly to the sum 1.
  MatrixXd reduced(const std::vector<int>& vertices) const {
    const auto n = Index(vertices.size());
    MatrixXd projected(n, barycentric_.cols());
    for (Index v = 0; v < n; ++v) {
      projected.row(v) = barycentric_.row(vertices[std::size_t(v)]);
    }
    projected.rowwise() +=
        ((1.0 - projected.colwise().sum().array()) / double(n)).matrix();
    const int rest = degree_ - int(n);
    if (n == 3) return bernstein<2>(rest, projected.bottomRows<2>()).value;
    // Monomials: of degree 2 at most.
    MatrixXd powers(barycentric_.cols(), rest + 1);
    for (int k = 0; k <= rest; ++k) {
      powers.col(k) =
          (projected.row(1) - projected.row(0)).array().pow(k).matrix();
    }
    return powers;
  }

  Spread spread(std::vector<int> vertices) const {
    Spread result;
    Eigen::VectorXd product = Eigen::VectorXd::Ones(barycentric_.cols());
    for (const int v : vertices) {
      product.array() *= barycentric_.row(v).transpose().array();
    }
    for (std::size_t i = 0; i < lattice_.size(); ++i) {
      int sum = 0;
      bool inner = true;
      for (const int v : vertices) {
        sum += lattice_[i][std::size_t(v)];
        inner = inner && lattice_[i][std::size_t(v)] > 0;
      }
      if (inner && sum == degree_) result.nodes.push_back(int(i));
    }
    if (!result.nodes.empty()) {
      const MatrixXd values = product.asDiagonal() * reduced(vertices);
      MatrixXd at_nodes(Index(result.nodes.size()), values.cols());
      for (std::size_t i = 0; i < result.nodes.size(); ++i) {
        at_nodes.row(Index(i)) = values.row(result.nodes[i]);
      }
      result.matrix = values * at_nodes.inverse();
    }
    result.vertices = std::move(vertices);
    return result;
  }

  int degree_;
  std::vector<SimplexIndex<3>> lattice_;
  Eigen::Matrix4Xd barycentric_;  ///< of the nodes
  std::vector<Spread> edges_, faces_;
};

}  // namespace

void blend_tetrahedra(PartMesh<3>& mesh, const CylindricalEntities& round,
                      int file_order) {
  const TetrahedronBlend blend(mesh.degree);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (!round.touch(mesh.cells[c])) continue;
    mesh.cell_points[c] = blend.move(mesh, round, int(c), file_order);
  }
}

}  // namespace clevis::mesh
