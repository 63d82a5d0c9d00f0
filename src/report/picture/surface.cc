#include "report/picture/surface.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

namespace clevis::report {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d extents(const Surface& surface) {
  return surface.points.colwise().maxCoeff() -
         surface.points.colwise().minCoeff();
}

/// Sum of the normals of triangles that hold the point nearest to a place.
Vector3d normal_at(const Surface& surface, const Vector3d& place) {
  Eigen::Index nearest = 0;
  (surface.points.rowwise() - place.transpose())
      .rowwise()
      .squaredNorm()
      .minCoeff(&nearest);
  Vector3d sum = Vector3d::Zero();
  for (const auto& [a, b, c] : surface.triangles) {
    if (a != nearest && b != nearest && c != nearest) continue;
    const Vector3d first = surface.points.row(a);
    sum += (surface.points.row(b).transpose() - first)
               .cross(surface.points.row(c).transpose() - first);
  }
  return sum.norm() > 0.0 ? sum.normalized() : Vector3d::UnitZ();
}

}  // namespace

Sight sight(const Vector3d& towards, const Vector3d& right) {
  const Vector3d eye = towards.normalized();
  const Vector3d across = (right - right.dot(eye) * eye).normalized();
  Matrix3d rows;
  rows << across.transpose(), eye.cross(across).transpose(), eye.transpose();
  return rows;
}

bool is_seen(const Surface& surface, const Sight& sight,
             const Vector3d& place) {
  const double margin = 2e-3 * extents(surface).norm();
  const Vector3d at = sight * place;
  const Eigen::MatrixX3d seen = surface.points * sight.transpose();
  return std::ranges::none_of(surface.triangles, [&](const auto& corners) {
    const Vector3d a = seen.row(corners[0]), b = seen.row(corners[1]),
                   c = seen.row(corners[2]);
    if (std::max({a.z(), b.z(), c.z()}) < at.z() + margin) return false;
    Eigen::Matrix2d sides;
    sides << (b - a).head<2>(), (c - a).head<2>();
    const double area = sides.determinant();
    if (area == 0.0) return false;
    const Eigen::Vector2d share = sides.inverse() * (at - a).head<2>();
    return share.minCoeff() >= 0.0 && share.sum() <= 1.0 &&
           a.z() + share[0] * (b - a).z() + share[1] * (c - a).z() >
               at.z() + margin;
  });
}

Sight best_sight(const Surface& surface, const Vector3d& marked) {
  constexpr double kFlat = 1e-6, kTall = 1.6;
  const Vector3d size = extents(surface);
  if (size.z() <= kFlat * size.norm()) {
    return sight(Vector3d::UnitZ(), size.y() > kTall * size.x()
                                        ? Vector3d::UnitY()
                                        : Vector3d::UnitX());
  }
  std::array<int, 3> order{0, 1, 2};  // longest first
  std::ranges::sort(order, std::ranges::greater{}, [&size](int axis) {
    return size[axis];
  });
  constexpr std::array<double, 3> kAskew{0.4, 0.6, 0.7};
  const Vector3d normal = normal_at(surface, marked);
  Sight best;
  double best_rank = -10.0;
  for (unsigned octant = 0; octant < 8; ++octant) {
    Vector3d towards;
    for (std::size_t k = 0; k < 3; ++k) {
      towards[order[k]] = (octant >> k & 1U) != 0 ? -kAskew[k] : kAskew[k];
    }
    const Sight tried =
        sight(towards, towards[order[1]] * Vector3d::Unit(order[0]));
    const double rank = normal.dot(towards) +
                        (is_seen(surface, tried, marked) ? 2.0 : 0.0) +
                        1e-3 * towards.sum();
    if (rank > best_rank) {
      best_rank = rank;
      best = tried;
    }
  }
  return best;
}

}  // namespace clevis::report
