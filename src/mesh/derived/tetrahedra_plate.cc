#include "mesh/derived/tetrahedra_plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "mesh/basis/simplex_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/quality/mass_properties.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Edge = std::pair<unsigned, unsigned>;

enum class Side { kBottom, kTop, kUpright, kOther };

class TetrahedraPlate {
 public:
  explicit TetrahedraPlate(const PartMesh<3>& mesh)
      : mesh_(mesh),
        tolerance_(1e-8 * size_of(mesh)),
        at_nodes_(
            simplex_lagrange<2>(mesh.degree, simplex_nodes<2>(mesh.degree))) {
    const auto lower = [](const auto& a, const auto& b) {
      return a.z() < b.z();
    };
    const auto [low, high] =
        std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(), lower);
    low_ = low->z();
    high_ = high->z();
  }

  std::optional<PartMesh<2>> mid_plane() {
    for (const BoundaryFace& face : mesh_.boundary) {
      sides_.push_back(side_of(face));
      if (sides_.back() == Side::kOther) return std::nullopt;
    }
    PartMesh<2> flat;
    flat.shape = CellShape::kSimplex;
    flat.degree = mesh_.degree;
    flat.thickness = high_ - low_;
    flat.mid_plane_z = 0.5 * (high_ + low_);
    add_triangles(flat);
    const std::vector<int> group = side_groups(flat);
    add_boundary(group, flat);
    if (!groups_reach_through(group, flat)) return std::nullopt;
    return flat;
  }

 private:
  Matrix3Xd face_points(const BoundaryFace& face) const {
    const auto lattice = simplex_face_lattice<3>(mesh_.degree, face.face);
    return mesh_.cell_points[std::size_t(face.cell)](Eigen::all, lattice);
  }

  /// Its polynomial leans by what it misses of the cylinder, its nodes not.
  bool is_on_upright_cylinder(const BoundaryFace& face) const {
    if (face.group < 0) return false;
    const auto& cylinder = mesh_.groups[std::size_t(face.group)].cylinder;
    return cylinder && cylinder->axis_L.head<2>().norm() <= 1e-8;
  }

  /// The flat facet through its corners.
  bool stands_upright(const BoundaryFace& face) const {
    const auto v = corners(face);
    const Eigen::Vector3d n =
        (mesh_.vertices[v[1]] - mesh_.vertices[v[0]])
            .cross(mesh_.vertices[v[2]] - mesh_.vertices[v[0]]);
    return std::abs(n.z()) <= 1e-8 * n.norm();
  }

  Side side_of(const BoundaryFace& face) const {
    const Matrix3Xd points = face_points(face);
    const auto at_height = [&](double z) {
      return (points.row(2).array() - z).abs().maxCoeff() <= tolerance_;
    };
    if (at_height(low_)) return Side::kBottom;
    if (at_height(high_)) return Side::kTop;
    if (is_on_upright_cylinder(face)) return Side::kUpright;
    const Matrix3Xd a = points * at_nodes_.slope[0].transpose();
    const Matrix3Xd b = points * at_nodes_.slope[1].transpose();
    // Facets put on a cylinder lean like those of a round group.
    const double lean = stands_upright(face) ? 1e-4 : 1e-7;
    for (Index q = 0; q < points.cols(); ++q) {
      const Eigen::Vector3d t1 = a.col(q), t2 = b.col(q), n = t1.cross(t2);
      if (!(std::abs(n.z()) <= lean * n.norm())) return Side::kOther;
    }
    return Side::kUpright;
  }

  std::array<unsigned, 3> corners(const BoundaryFace& face) const {
    const FaceVertices v = face_vertices(mesh_, face.cell, face.face);
    return {v[0], v[1], v[2]};
  }

  /// The triangles at the bottom, counter-clockwise from above.
  void add_triangles(PartMesh<2>& flat) {
    const auto lattice = simplex_lattice<2>(mesh_.degree);
    std::map<unsigned, unsigned> number;
    for (std::size_t f = 0; f < sides_.size(); ++f) {
      if (sides_[f] != Side::kBottom) continue;
      for (const unsigned v : corners(mesh_.boundary[f])) number[v] = 0;
    }
    for (auto& [old, now] : number) {
      now = unsigned(flat.vertices.size());
      flat.vertices.emplace_back(mesh_.vertices[old].head<2>());
    }
    for (std::size_t f = 0; f < sides_.size(); ++f) {
      if (sides_[f] != Side::kBottom) continue;
      const BoundaryFace& face = mesh_.boundary[f];
      auto vertices = corners(face);
      // Outward is down: seen from above the face's own turn is the other.
      const bool turn = simplex_face_sense(face.face) > 0.0;
      if (turn) std::swap(vertices[1], vertices[2]);
      const Matrix3Xd points = face_points(face);
      Eigen::Matrix2Xd flat_points(2, points.cols());
      for (std::size_t i = 0; i < lattice.size(); ++i) {
        SimplexIndex<2> from = lattice[i];
        if (turn) std::swap(from[1], from[2]);
        const auto at = std::find(lattice.begin(), lattice.end(), from);
        flat_points.col(Index(i)) = points.col(at - lattice.begin()).head<2>();
      }
      auto& cell = flat.cells.emplace_back();
      for (const unsigned v : vertices) cell.push_back(number.at(v));
      flat.cell_points.push_back(flat_points);
      bottom_.push_back(vertices);
    }
  }

  /// Groups with a face on top or bottom stay in 3-D.
  std::vector<int> side_groups(PartMesh<2>& flat) const {
    std::vector<bool> on_lid(mesh_.groups.size(), false);
    for (std::size_t f = 0; f < sides_.size(); ++f) {
      const int group = mesh_.boundary[f].group;
      if (group >= 0 && sides_[f] != Side::kUpright) {
        on_lid[std::size_t(group)] = true;
      }
    }
    std::vector<int> renumbered(mesh_.groups.size(), -1);
    for (std::size_t g = 0; g < on_lid.size(); ++g) {
      if (on_lid[g]) continue;
      renumbered[g] = int(flat.groups.size());
      flat.groups.push_back(mesh_.groups[g]);
    }
    return renumbered;
  }

  void add_boundary(const std::vector<int>& group, PartMesh<2>& flat) const {
    std::map<Edge, int> upright;  // group of the side above each edge
    for (std::size_t f = 0; f < sides_.size(); ++f) {
      if (sides_[f] != Side::kUpright) continue;
      const auto v = corners(mesh_.boundary[f]);
      for (std::size_t a = 0; a < 3; ++a) {
        upright[std::minmax(v[a], v[(a + 1) % 3])] = mesh_.boundary[f].group;
      }
    }
    std::map<Edge, int> uses;
    const auto edge_of = [&](std::size_t cell, int edge) {
      const auto& ends = simplex_face<2>(edge);
      return Edge(std::minmax(bottom_[cell][std::size_t(ends[0])],
                              bottom_[cell][std::size_t(ends[1])]));
    };
    for (std::size_t c = 0; c < bottom_.size(); ++c) {
      for (int edge = 0; edge < 3; ++edge) ++uses[edge_of(c, edge)];
    }
    for (std::size_t c = 0; c < bottom_.size(); ++c) {
      for (int edge = 0; edge < 3; ++edge) {
        const Edge key = edge_of(c, edge);
        if (uses.at(key) > 1) continue;
        const auto side = upright.find(key);
        const int g = side == upright.end() ? -1 : side->second;
        flat.boundary.push_back(
            {int(c), edge, g < 0 ? -1 : group[std::size_t(g)]});
      }
    }
  }

  /// Each group's area is that of its edges times the thickness.
  bool groups_reach_through(const std::vector<int>& group,
                            const PartMesh<2>& flat) const {
    std::vector<double> length(flat.groups.size(), 0.0);
    const Quadrature rule = gauss(flat.degree + 4);
    for (const BoundaryFace& face : flat.boundary) {
      if (face.group < 0) continue;
      const auto& ends = simplex_face<2>(face.face);
      Eigen::Matrix<double, 2, 3> corner;
      corner << 0, 1, 0, 0, 0, 1;
      const Eigen::Vector2d from = corner.col(ends[0]);
      const Eigen::Vector2d along = corner.col(ends[1]) - from;
      const SimplexPoints<2> at =
          (along * rule.points.transpose()).colwise() + from;
      const auto grid = map_simplex<2>(flat.cell_points[std::size_t(face.cell)],
                                       simplex_lagrange<2>(flat.degree, at));
      for (Index q = 0; q < at.cols(); ++q) {
        length[std::size_t(face.group)] +=
            rule.weights[q] * (grid.jacobian(q) * along).norm();
      }
    }
    for (std::size_t g = 0; g < group.size(); ++g) {
      if (group[g] < 0) continue;
      const double want = flat.thickness * length[std::size_t(group[g])];
      const double area = face_properties(mesh_, int(g)).area;
      if (!(std::abs(area - want) <= 1e-5 * area)) return false;
    }
    return true;
  }

  const PartMesh<3>& mesh_;
  double tolerance_, low_{}, high_{};
  SimplexTable<2> at_nodes_;
  std::vector<Side> sides_;                      ///< per boundary face
  std::vector<std::array<unsigned, 3>> bottom_;  ///< vertices per triangle
};

}  // namespace

std::optional<PartMesh<2>> tetrahedra_mid_plane(const PartMesh<3>& mesh) {
  return TetrahedraPlate(mesh).mid_plane();
}

}  // namespace clevis::mesh
