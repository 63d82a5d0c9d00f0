#include "mesh/quality/mass_properties.h"

#include <algorithm>
#include <limits>

#include <Eigen/Dense>

#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/simplex_quadrature.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// ∫ 1, ∫ r and ∫ r rᵀ of a body or surface about a point near to it, so that
/// the parallel-axis shift loses no digits.
struct Moments {
  explicit Moments(const Vector3d& about) : origin(about) {}

  void add(const Vector3d& p, double weight) {
    const Vector3d r = p - origin;
    zeroth += weight;
    first += weight * r;
    second += weight * r * r.transpose();
  }
  Vector3d centroid() const {
    return zeroth > 0.0 ? Vector3d(origin + first / zeroth) : origin;
  }
  /// ∫ (|r|² I − r rᵀ) about the centroid.
  Matrix3d inertia() const {
    if (!(zeroth > 0.0)) return Matrix3d::Zero();
    const Matrix3d central = second - first * first.transpose() / zeroth;
    return central.trace() * Matrix3d::Identity() - central;
  }

  Vector3d origin;
  double zeroth = 0.0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
};

Vector3d mean_vertex(const PartMesh<3>& mesh) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& v : mesh.vertices) sum += v;
  return sum / double(mesh.vertices.size());
}

void add_tetrahedra(const PartMesh<3>& mesh, Moments& moments) {
  // A rule that takes det J exactly; see mass_properties for r rᵀ det J. Two
  // points a direction do where the cell is straight.
  const auto rule = simplex_gauss<3>(std::max(2, (3 * mesh.degree + 1) / 2));
  const auto table = simplex_lagrange<3>(mesh.degree, rule.points);
  const auto short_rule = simplex_gauss<3>(2);
  const auto nodes = simplex_nodes<3>(mesh.degree);
  for (const auto& points : mesh.cell_points) {
    if (const auto edges = affine_edges<3>(points, nodes)) {
      const double det = edges->determinant();
      for (Index q = 0; q < short_rule.weights.size(); ++q) {
        moments.add(points.col(0) + *edges * short_rule.points.col(q),
                    short_rule.weights[q] * det);
      }
      continue;
    }
    const auto grid = map_simplex<3>(points, table);
    for (Index q = 0; q < grid.points.cols(); ++q) {
      moments.add(grid.points.col(q),
                  rule.weights[q] * grid.jacobian(q).determinant());
    }
  }
}

/// Points of a group's faces with their area vectors times the weights.
/// @param order  points a direction.
template <class Visitor>
void visit_triangles(const PartMesh<3>& mesh, int group, int order,
                     const Visitor& visit) {
  const auto rule = simplex_gauss<2>(order);
  const auto table = simplex_lagrange<2>(mesh.degree, rule.points);
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const auto lattice = simplex_face_lattice<3>(mesh.degree, face.face);
    const Matrix3Xd& cell = mesh.cell_points[std::size_t(face.cell)];
    Matrix3Xd nodes(3, Index(lattice.size()));
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      nodes.col(Index(i)) = cell.col(lattice[i]);
    }
    const Matrix3Xd points = nodes * table.value.transpose();
    const Matrix3Xd a = nodes * table.slope[0].transpose();
    const Matrix3Xd b = nodes * table.slope[1].transpose();
    const double sense = simplex_face_sense(face.face);
    for (Index q = 0; q < points.cols(); ++q) {
      const Vector3d t1 = a.col(q), t2 = b.col(q);
      visit(points.col(q), sense * rule.weights[q] * t1.cross(t2));
    }
  }
}

part::MassProperties with_density(const Moments& moments, double density) {
  return {density * moments.zeroth, moments.centroid(),
          density * moments.inertia()};
}

}  // namespace

part::MassProperties mass_properties(const PartMesh<3>& mesh, double density) {
  Moments moments(mean_vertex(mesh));
  if (mesh.shape == CellShape::kSimplex) {
    add_tetrahedra(mesh, moments);
    return with_density(moments, density);
  }
  // Per direction det J has degree 3k − 1: the mass is exact. r rᵀ det J has
  // 5k − 1, but its upper terms vanish with the curvature of a cell: against
  // the exact rule, ten times as dear, inertia differs by 1e-13 on the meshes
  // of the landing gear.
  const Quadrature rule = gauss(std::max(3, (3 * mesh.degree + 1) / 2));
  const LagrangeBasis basis = lagrange(gauss_lobatto(mesh.degree), rule.points);
  const Index n = rule.points.size();
  for (const auto& points : mesh.cell_points) {
    const auto grid = map_grid<3>(points, {&basis, &basis, &basis});
    for (Index q = 0; q < grid.points.cols(); ++q) {
      moments.add(grid.points.col(q), rule.weights[q % n] *
                                          rule.weights[q / n % n] *
                                          rule.weights[q / (n * n)] *
                                          grid.jacobian(q).determinant());
    }
  }
  return with_density(moments, density);
}

part::MassProperties mass_properties(const PartMesh<2>& mesh, double density) {
  Vector3d about(0.0, 0.0, mesh.mid_plane_z);
  for (const auto& v : mesh.vertices) {
    about.head<2>() += v / double(mesh.vertices.size());
  }
  Moments moments(about);
  Vector3d p = about;
  const auto add = [&](const MappedGrid<2>& grid, const auto& weight) {
    for (Index q = 0; q < grid.points.cols(); ++q) {
      p.head<2>() = grid.points.col(q);
      moments.add(p,
                  mesh.thickness * weight(q) * grid.jacobian(q).determinant());
    }
  };
  if (mesh.shape == CellShape::kSimplex) {
    const auto rule = simplex_gauss<2>(2 * mesh.degree + 1);
    const auto table = simplex_lagrange<2>(mesh.degree, rule.points);
    for (const auto& points : mesh.cell_points) {
      add(map_simplex<2>(points, table), [&](Index q) {
        return rule.weights[q];
      });
    }
  } else {
    const Quadrature rule = gauss(2 * mesh.degree + 1);
    const LagrangeBasis basis =
        lagrange(gauss_lobatto(mesh.degree), rule.points);
    const Index n = rule.points.size();
    for (const auto& points : mesh.cell_points) {
      add(map_grid<2>(points, {&basis, &basis}), [&](Index q) {
        return rule.weights[q % n] * rule.weights[q / n];
      });
    }
  }
  moments.second(2, 2) +=
      moments.zeroth * mesh.thickness * mesh.thickness / 12.0;
  return with_density(moments, density);
}

namespace {

/// @param order  points a direction.
/// Points of a hexahedron on a local face: along two directions whose tangents'
/// cross product points along the third.
Matrix3Xd points_on_face(const Matrix3Xd& cell_points, int degree, int face) {
  const Index n = degree + 1;
  const std::array<Index, 3> strides = {1, n, n * n};
  const auto normal = unsigned(face / 2);
  const Index first = face % 2 == 0 ? 0 : degree * strides[normal];
  Matrix3Xd points(3, n * n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      points.col(i + n * j) =
          cell_points.col(first + i * strides[(normal + 1) % 3] +
                          j * strides[(normal + 2) % 3]);
    }
  }
  return points;
}

/// A face's polynomial at a grid of points.
/// @param nodes  3 × nodes². @param first, second  points × nodes.
Matrix3Xd on_grid(const Matrix3Xd& nodes, const Eigen::MatrixXd& first,
                  const Eigen::MatrixXd& second) {
  Matrix3Xd along(3, first.rows() * first.cols());
  contract(nodes.data(), first, along.data(), 3, first.cols());
  Matrix3Xd points(3, first.rows() * second.rows());
  contract(along.data(), second, points.data(), 3 * first.rows(), 1);
  return points;
}

/// @param order  points a direction.
template <class Visitor>
void visit_quadrangles(const PartMesh<3>& mesh, int group, int order,
                       const Visitor& visit) {
  const Quadrature rule = gauss(order);
  const LagrangeBasis basis = lagrange(gauss_lobatto(mesh.degree), rule.points);
  const Index n = rule.points.size();
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const Matrix3Xd nodes = points_on_face(
        mesh.cell_points[std::size_t(face.cell)], mesh.degree, face.face);
    const Matrix3Xd points = on_grid(nodes, basis.value, basis.value);
    const Matrix3Xd a = on_grid(nodes, basis.slope, basis.value);
    const Matrix3Xd b = on_grid(nodes, basis.value, basis.slope);
    const double sense = face.face % 2 == 0 ? -1.0 : 1.0;
    for (Index q = 0; q < n * n; ++q) {
      const Vector3d t1 = a.col(q), t2 = b.col(q);
      visit(points.col(q),
            sense * rule.weights[q % n] * rule.weights[q / n] * t1.cross(t2));
    }
  }
}

}  // namespace

FaceProperties face_properties(const PartMesh<3>& mesh, int group) {
  FaceProperties properties;
  Moments moments(mean_vertex(mesh));
  const auto add = [&](const Vector3d& p, const Vector3d& area) {
    moments.add(p, area.norm());
    properties.area_vector += area;
    properties.area_moment += p.cross(area);
    if (area.norm() > 0.0) {
      properties.normal_square += area * area.transpose() / area.norm();
    }
  };
  if (mesh.shape == CellShape::kSimplex) {
    visit_triangles(mesh, group, 2 * mesh.degree + 4, add);
  } else {
    // The area element is no polynomial on a curved face; a smooth function,
    // for which this many points reach rounding.
    visit_quadrangles(mesh, group, 4 * mesh.degree + 4, add);
  }
  properties.area = moments.zeroth;
  properties.centroid = moments.centroid();
  properties.second_moment = moments.inertia();
  return properties;
}

SurfaceSample sample_surface(const PartMesh<3>& mesh, int group) {
  constexpr int kOrder = 4;
  std::vector<Vector3d> points, areas;
  const auto add = [&](const Vector3d& p, const Vector3d& area) {
    points.push_back(p);
    areas.push_back(area);
  };
  if (mesh.shape == CellShape::kSimplex) {
    visit_triangles(mesh, group, kOrder, add);
  } else {
    visit_quadrangles(mesh, group, kOrder, add);
  }
  SurfaceSample sample{Matrix3Xd(3, Index(points.size())),
                       Matrix3Xd(3, Index(points.size()))};
  for (std::size_t q = 0; q < points.size(); ++q) {
    sample.points.col(Index(q)) = points[q];
    sample.areas.col(Index(q)) = areas[q];
  }
  return sample;
}

std::vector<std::pair<double, double>> spans_along(const PartMesh<3>& mesh,
                                                   int group,
                                                   const Vector3d& point,
                                                   const Vector3d& axis) {
  constexpr double kTouching = 1e-6;  // of a face
  std::vector<std::pair<double, double>> faces;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const unsigned vertex : face_vertices(mesh, face.cell, face.face)) {
      if (vertex == kNoVertex) continue;
      const double at = axis.dot(mesh.vertices[vertex] - point);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    faces.emplace_back(low, high);
  }
  std::ranges::sort(faces);
  std::vector<std::pair<double, double>> spans;
  for (const auto& [low, high] : faces) {
    const double slack = kTouching * (high - low);
    if (spans.empty() || low > spans.back().second + slack) {
      spans.emplace_back(low, high);
    } else {
      spans.back().second = std::max(spans.back().second, high);
    }
  }
  return spans;
}

Matrix3Xd face_corners(const PartMesh<3>& mesh, int group) {
  std::vector<Vector3d> corners;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    for (const unsigned vertex : face_vertices(mesh, face.cell, face.face)) {
      if (vertex != kNoVertex) corners.push_back(mesh.vertices[vertex]);
    }
  }
  Matrix3Xd points(3, Index(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    points.col(Index(k)) = corners[k];
  }
  return points;
}

}  // namespace clevis::mesh
