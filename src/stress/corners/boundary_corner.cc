#include "stress/corners/boundary_corner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "elasticity/fe_space/tabulation.h"
#include "mesh/cells/topology.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;
using Key = std::pair<unsigned, unsigned>;

template <int dim>
using Reference = Eigen::Matrix<double, dim, 1>;

/// A corner of the reference cell: its vertices, where its tangents are
/// taken, and two directions along the faces that meet there.
template <int dim>
struct LocalCorner {
  std::array<std::size_t, 2> vertices{};
  Reference<dim> tip, along;
  std::array<Reference<dim>, 2> direction;
  std::array<int, 2> face{};
};

template <int dim>
Reference<dim> reference_vertex(mesh::CellShape shape, std::size_t v) {
  Reference<dim> point = Reference<dim>::Zero();
  for (int d = 0; d < dim; ++d) {
    const auto k = static_cast<std::size_t>(d);
    point[d] = shape == mesh::CellShape::kTensor
                   ? static_cast<double>((v >> k) & 1U)
                   : (v == k + 1 ? 1.0 : 0.0);
  }
  return point;
}

/// Corner of a square, or of a cube along the third axis `along`.
template <int dim>
LocalCorner<dim> tensor_corner(std::size_t vertex, int along) {
  LocalCorner<dim> corner;
  corner.tip = reference_vertex<dim>(mesh::CellShape::kTensor, vertex);
  corner.along.setZero();
  corner.vertices = {vertex, vertex};
  if (along >= 0) {
    corner.tip[along] = 0.5;
    corner.along[along] = 1.0;
    corner.vertices[1] = vertex | (1U << along);
  }
  std::size_t k = 0;
  for (int d = 0; d < dim; ++d) {
    if (d == along) continue;
    const int other = dim == 2 ? 1 - d : 3 - d - along;
    corner.direction[k] = Reference<dim>::Unit(d) * (1.0 - 2.0 * corner.tip[d]);
    corner.face[k] = 2 * other + static_cast<int>(corner.tip[other]);
    ++k;
  }
  return corner;
}

/// Local face of a simplex that holds these vertices, as deal.II numbers them.
int simplex_face(const std::vector<std::size_t>& vertices) {
  // Faces by the vertex that they lack.
  static constexpr std::array<int, 3> kOfTriangle = {1, 2, 0};
  static constexpr std::array<int, 4> kOfTetrahedron = {3, 2, 1, 0};
  const bool plane = vertices.size() == 2;
  for (std::size_t v = 0; v < (plane ? 3U : 4U); ++v) {
    if (std::ranges::count(vertices, v) == 0) {
      return plane ? kOfTriangle[v] : kOfTetrahedron[v];
    }
  }
  return -1;
}

template <int dim>
LocalCorner<dim> simplex_corner(std::size_t a, std::size_t b) {
  const auto vertex = [](std::size_t v) {
    return reference_vertex<dim>(mesh::CellShape::kSimplex, v);
  };
  LocalCorner<dim> corner;
  corner.vertices = {a, b};
  corner.tip = 0.5 * (vertex(a) + vertex(b));
  corner.along = vertex(b) - vertex(a);
  std::size_t k = 0;
  for (std::size_t v = 0; v < dim + 1; ++v) {
    if (v == a || v == b) continue;
    corner.direction[k] = vertex(v) - corner.tip;
    corner.face[k] = dim == 2 ? simplex_face({a, v}) : simplex_face({a, b, v});
    ++k;
  }
  return corner;
}

template <int dim>
std::vector<LocalCorner<dim>> local_corners(mesh::CellShape shape) {
  std::vector<LocalCorner<dim>> corners;
  if (shape == mesh::CellShape::kSimplex) {
    for (std::size_t a = 0; a < dim + 1; ++a) {
      if (dim == 2) corners.push_back(simplex_corner<dim>(a, a));
      for (std::size_t b = a + 1; dim == 3 && b < 4; ++b) {
        corners.push_back(simplex_corner<dim>(a, b));
      }
    }
    return corners;
  }
  for (std::size_t v = 0; v < (1U << dim); ++v) {
    if (dim == 2) corners.push_back(tensor_corner<dim>(v, -1));
    for (int along = 0; dim == 3 && along < 3; ++along) {
      if (((v >> along) & 1U) == 0) {
        corners.push_back(tensor_corner<dim>(v, along));
      }
    }
  }
  return corners;
}

template <int dim>
Vector3d in_space(const Reference<dim>& vector, double z = 0.0) {
  Vector3d result(0.0, 0.0, z);
  result.head<dim>() = vector;
  return result;
}

template <int dim>
class Collector {
 public:
  explicit Collector(const mesh::PartMesh<dim>& mesh)
      : mesh_(mesh), local_(local_corners<dim>(mesh.shape)) {
    elasticity::ReferencePoints<dim> tips(
        dim, static_cast<Eigen::Index>(local_.size()));
    auto ends = std::array{tips, tips};
    for (std::size_t k = 0; k < local_.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      tips.col(column) = local_[k].tip;
      for (std::size_t s = 0; s < 2; ++s) {
        ends[s].col(column) = local_[k].tip + local_[k].direction[s];
      }
    }
    const auto tabulate = [&](const auto& points) {
      return elasticity::tabulate_geometry<dim>(mesh.shape, mesh.degree,
                                                points);
    };
    table_ = tabulate(tips);
    ends_ = {tabulate(ends[0]), tabulate(ends[1])};
    group_.resize(mesh.cells.size());
    on_boundary_.resize(mesh.vertices.size());
    for (auto& faces : group_) faces.fill(kInside);
    for (const auto& face : mesh.boundary) {
      group_[static_cast<std::size_t>(face.cell)]
            [static_cast<std::size_t>(face.face)] = face.group;
    }
  }

  std::vector<BoundaryCorner> collect() {
    visit([&](std::size_t c, std::size_t k) {
      for (const int face : local_[k].face) {
        if (group_[c][static_cast<std::size_t>(face)] == kInside) continue;
        const Key key = key_of(c, k);
        found_[key];
        on_boundary_[key.first] = on_boundary_[key.second] = true;
      }
    });
    visit([&](std::size_t c, std::size_t k) {
      const Key key = key_of(c, k);
      if (!on_boundary_[key.first] || !on_boundary_[key.second]) return;
      const auto corner = found_.find(key);
      if (corner != found_.end()) add(c, k, key, corner->second);
    });
    std::vector<BoundaryCorner> result;
    for (auto& [key, entry] : found_) {
      if (entry.sides == 2) result.push_back(entry.corner);
    }
    return result;
  }

 private:
  static constexpr int kInside = -2;
  struct Entry {
    BoundaryCorner corner;
    int sides{};  // boundary faces that meet here
  };

  template <typename Visitor>
  void visit(const Visitor& visitor) const {
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      for (std::size_t k = 0; k < local_.size(); ++k) visitor(c, k);
    }
  }

  Key key_of(std::size_t cell, std::size_t k) const {
    const auto& vertices = mesh_.cells[cell];
    return std::minmax(
        {vertices[local_[k].vertices[0]], vertices[local_[k].vertices[1]]});
  }

  void add(std::size_t cell, std::size_t k, const Key& key, Entry& entry) {
    const LocalCorner<dim>& local = local_[k];
    const auto row = static_cast<Eigen::Index>(k);
    const auto& points = mesh_.cell_points[cell];
    const auto jacobian = jacobian_at(table_, cell, k);
    BoundaryCorner& corner = entry.corner;
    corner.vertices = {key.first, key.second};
    corner.at = in_space<dim>(points * table_.values.row(row).transpose(),
                              dim == 2 ? mesh_.mid_plane_z : 0.0);
    Vector3d axis = Vector3d::UnitZ();
    if constexpr (dim == 3) {
      axis = (jacobian * local.along).normalized();
      const bool turned = mesh_.cells[cell][local.vertices[0]] != key.first;
      if (turned) axis = -axis;
    }
    corner.axis = axis;
    std::array<Vector3d, 2> side;
    for (std::size_t s = 0; s < 2; ++s) {
      side[s] = in_space<dim>(jacobian * local.direction[s]);
      side[s] = (side[s] - axis.dot(side[s]) * axis).normalized();
    }
    const double sine = side[0].cross(side[1]).dot(axis);
    corner.angle += std::atan2(std::abs(sine), side[0].dot(side[1]));
    for (std::size_t s = 0; s < 2; ++s) {
      const int group = group_[cell][static_cast<std::size_t>(local.face[s])];
      if (group == kInside) continue;
      ++entry.sides;
      // The cell's material lies counter-clockwise of its first side.
      const bool first = (sine > 0.0) == (s == 0);
      const Vector3d end =
          in_space<dim>(jacobian_at(ends_[s], cell, k) * local.direction[s]);
      const double turn =
          std::atan2(end.cross(side[s]).dot(axis), end.dot(side[s]));
      corner.sides[first ? 0 : 1] = {
          side[s], group, extent(cell, local.face[s], corner.at, axis),
          first ? turn : -turn};
    }
    for (const unsigned v : mesh_.cells[cell]) {
      corner.reach = std::max(corner.reach, across(v, corner.at, axis));
    }
  }

  Eigen::Matrix<double, dim, dim> jacobian_at(const elasticity::Tabulation& at,
                                              std::size_t cell,
                                              std::size_t k) const {
    Eigen::Matrix<double, dim, dim> jacobian;
    for (int d = 0; d < dim; ++d) {
      jacobian.col(d) =
          mesh_.cell_points[cell] * at.gradients[static_cast<std::size_t>(d)]
                                        .row(static_cast<Eigen::Index>(k))
                                        .transpose();
    }
    return jacobian;
  }

  /// Way from a point to a vertex across an axis [m].
  double across(unsigned vertex, const Vector3d& from,
                const Vector3d& axis) const {
    const Vector3d arm = in_space<dim>(mesh_.vertices[vertex],
                                       dim == 2 ? mesh_.mid_plane_z : 0.0) -
                         from;
    return (arm - axis.dot(arm) * axis).norm();
  }

  /// How far a face of a cell reaches from a point across an axis [m].
  double extent(std::size_t cell, int face, const Vector3d& from,
                const Vector3d& axis) const {
    double farthest = 0.0;
    for (const unsigned v :
         mesh::face_vertices(mesh_, static_cast<int>(cell), face)) {
      if (v == mesh::kNoVertex) continue;
      farthest = std::max(farthest, across(v, from, axis));
    }
    return farthest;
  }

  const mesh::PartMesh<dim>& mesh_;
  std::vector<LocalCorner<dim>> local_;
  elasticity::Tabulation table_;                ///< at the corners
  std::array<elasticity::Tabulation, 2> ends_;  ///< far ends of their faces
  std::vector<std::array<int, 6>> group_;
  std::vector<bool> on_boundary_;
  std::map<Key, Entry> found_;
};

}  // namespace

double distance_from_edge(const Eigen::Vector3d& point,
                          const Eigen::Vector3d& from,
                          const Eigen::Vector3d& to) {
  const Eigen::Vector3d along = to - from;
  const double square = along.squaredNorm();
  const double part =
      square > 0.0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0)
                   : 0.0;
  return (point - from - part * along).norm();
}

Vector3d BoundaryCorner::bisector() const {
  return Eigen::AngleAxisd(0.5 * angle, axis) * sides[0].direction;
}

template <int dim>
std::vector<BoundaryCorner> boundary_corners(const mesh::PartMesh<dim>& mesh) {
  return Collector<dim>(mesh).collect();
}

template std::vector<BoundaryCorner> boundary_corners<2>(
    const mesh::PartMesh<2>&);
template std::vector<BoundaryCorner> boundary_corners<3>(
    const mesh::PartMesh<3>&);

}  // namespace clevis::stress
