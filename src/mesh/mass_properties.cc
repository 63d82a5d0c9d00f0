#include "mesh/mass_properties.h"

#include <algorithm>

#include <Eigen/Dense>

#include "mesh/tensor_basis.h"
#include "mesh/topology.h"

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

/// Points of a rule on the tetrahedron (collapsed Gauss, exact to degree 2)
/// and on the triangle, as barycentric weights of the corners.
struct SimplexRule {
  Eigen::MatrixXd weights_of_corners;  ///< corners × points
  double weight_each{};                ///< of the unit measure
};

SimplexRule tetrahedron_rule() {
  constexpr double a = 0.13819660112501051518;  // (5 - √5) / 20
  SimplexRule rule{Eigen::MatrixXd::Constant(4, 4, a), 0.25};
  rule.weights_of_corners.diagonal().setConstant(1.0 - 3.0 * a);
  return rule;
}

SimplexRule triangle_rule() {
  SimplexRule rule{Eigen::MatrixXd::Constant(3, 3, 1.0 / 6.0), 1.0 / 3.0};
  rule.weights_of_corners.diagonal().setConstant(2.0 / 3.0);
  return rule;
}

Vector3d mean_vertex(const PartMesh<3>& mesh) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& v : mesh.vertices) sum += v;
  return sum / double(mesh.vertices.size());
}

void add_tetrahedron(const Matrix3Xd& corners, Moments& moments) {
  static const SimplexRule rule = tetrahedron_rule();
  const Matrix3d J = corners.middleCols<3>(1).colwise() - corners.col(0);
  const double volume = J.determinant() / 6.0;
  const Matrix3Xd points = corners * rule.weights_of_corners;
  for (Index q = 0; q < points.cols(); ++q) {
    moments.add(points.col(q), rule.weight_each * volume);
  }
}

void add_triangle(const Matrix3d& corners, Moments& moments) {
  static const SimplexRule rule = triangle_rule();
  const Vector3d a = corners.col(1) - corners.col(0);
  const Vector3d b = corners.col(2) - corners.col(0);
  const double area = 0.5 * a.cross(b).norm();
  const Matrix3d points = corners * rule.weights_of_corners;
  for (Index q = 0; q < 3; ++q) {
    moments.add(points.col(q), rule.weight_each * area);
  }
}

/// Area vector of a tetrahedron's face, outward.
Vector3d outward_area(const Matrix3d& corners, const Vector3d& inside) {
  const Vector3d area =
      0.5 *
      (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
  return area.dot(corners.col(0) - inside) < 0.0 ? Vector3d(-area) : area;
}

part::MassProperties with_density(const Moments& moments, double density) {
  return {density * moments.zeroth, moments.centroid(),
          density * moments.inertia()};
}

}  // namespace

part::MassProperties mass_properties(const PartMesh<3>& mesh, double density) {
  Moments moments(mean_vertex(mesh));
  if (mesh.shape == CellShape::kSimplex) {
    for (const auto& points : mesh.cell_points) {
      add_tetrahedron(points, moments);
    }
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
  const Quadrature rule = gauss(2 * mesh.degree + 1);
  const LagrangeBasis basis = lagrange(gauss_lobatto(mesh.degree), rule.points);
  const Index n = rule.points.size();
  Vector3d p = about;
  for (const auto& points : mesh.cell_points) {
    const auto grid = map_grid<2>(points, {&basis, &basis});
    for (Index q = 0; q < grid.points.cols(); ++q) {
      p.head<2>() = grid.points.col(q);
      moments.add(p, mesh.thickness * rule.weights[q % n] *
                         rule.weights[q / n] * grid.jacobian(q).determinant());
    }
  }
  moments.second(2, 2) +=
      moments.zeroth * mesh.thickness * mesh.thickness / 12.0;
  return with_density(moments, density);
}

FaceProperties face_properties(const PartMesh<3>& mesh, int group) {
  FaceProperties properties;
  Moments moments(mean_vertex(mesh));
  // The area element is no polynomial on a curved face; a smooth function,
  // for which this many points reach rounding.
  const Quadrature rule = gauss(4 * mesh.degree + 4);
  const Eigen::VectorXd nodes = gauss_lobatto(mesh.degree);
  const LagrangeBasis inner = lagrange(nodes, rule.points);
  const std::array<LagrangeBasis, 2> ends = {
      lagrange(nodes, Eigen::VectorXd::Constant(1, 0.0)),
      lagrange(nodes, Eigen::VectorXd::Constant(1, 1.0))};
  const Index n = rule.points.size();
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    if (mesh.shape == CellShape::kSimplex) {
      const FaceVertices v = face_vertices(mesh, face.cell, face.face);
      Matrix3d corners;
      corners << mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]];
      add_triangle(corners, moments);
      const Vector3d area = outward_area(
          corners, mesh.cell_points[std::size_t(face.cell)].rowwise().mean());
      properties.area_vector += area;
      properties.area_moment += corners.rowwise().mean().cross(area);
      continue;
    }
    const auto normal = unsigned(face.face / 2);
    std::array<const LagrangeBasis*, 3> along = {&inner, &inner, &inner};
    along[normal] = &ends[unsigned(face.face % 2)];
    const auto grid =
        map_grid<3>(mesh.cell_points[std::size_t(face.cell)], along);
    const auto& a = grid.tangents[(normal + 1) % 3];
    const auto& b = grid.tangents[(normal + 2) % 3];
    const double sense = face.face % 2 == 0 ? -1.0 : 1.0;
    for (Index q = 0; q < n * n; ++q) {
      const Vector3d t1 = a.col(q), t2 = b.col(q), p = grid.points.col(q);
      const Vector3d area =
          sense * rule.weights[q % n] * rule.weights[q / n] * t1.cross(t2);
      moments.add(p, area.norm());
      properties.area_vector += area;
      properties.area_moment += p.cross(area);
    }
  }
  properties.area = moments.zeroth;
  properties.centroid = moments.centroid();
  properties.second_moment = moments.inertia();
  return properties;
}

}  // namespace clevis::mesh
