#include "loads/pressure/seat_traction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace clevis::loads {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

WallPoints::WallPoints(const part::Bore& bore, const Matrix3Xd& points,
                       const Matrix3Xd& outward)
    : normal(3, points.cols()),
      around(3, points.cols()),
      height(points.cols()) {
  for (Index q = 0; q < points.cols(); ++q) {
    const Vector3d p_CQ = points.col(q) - bore.p_LC;
    height[q] = p_CQ.dot(bore.axis_L);
    const Vector3d radial = p_CQ - height[q] * bore.axis_L;
    assert(std::abs(radial.norm() - bore.radius) < 0.1 * bore.radius &&
           "point is not on the wall of this cylinder");
    const Vector3d e_r = radial.normalized();
    normal.col(q) = outward.col(q).dot(e_r) < 0.0 ? Vector3d(-e_r) : e_r;
    around.col(q) = bore.axis_L.cross(e_r);
  }
}

BearingTraction::BearingTraction(const part::Bore& bore, const Wrench& wrench)
    : bore_(bore) {
  assert(bore.radius > 0.0 && bore.length > 0.0);
  const Vector3d& axis = bore.axis_L;
  const double l = bore.length;
  const double axial_force = wrench.force.dot(axis);
  const double axial_moment = wrench.moment.dot(axis);
  line_load_ = (wrench.force - axial_force * axis) / l;
  // ∫ s axis × (slope s) ds = axis × slope l³/12 is the moment normal to the
  // axis.
  line_load_slope_ = 12.0 / (l * l * l) * wrench.moment.cross(axis);
  const double wall = 2.0 * std::numbers::pi * bore.radius * l;
  axial_shear_ = axial_force / wall;
  torsional_shear_ = axial_moment / (wall * bore.radius);
}

Vector3d BearingTraction::traction(const Vector3d& p_LQ,
                                   const Vector3d& outward_LQ) const {
  return tractions(p_LQ, outward_LQ);
}

Matrix3Xd BearingTraction::tractions(const WallPoints& points) const {
  const double factor = 2.0 / (std::numbers::pi * bore_.radius);
  const Vector3d axial = axial_shear_ * bore_.axis_L;
  Matrix3Xd result(3, points.height.size());
  for (Index q = 0; q < result.cols(); ++q) {
    const auto normal = points.normal.col(q);
    const Vector3d line = line_load_ + points.height[q] * line_load_slope_;
    const double pressure = factor * std::max(0.0, -normal.dot(line));
    result.col(q) =
        axial + torsional_shear_ * points.around.col(q) - pressure * normal;
  }
  return result;
}

Vector3d BearingTraction::line_load(const Vector3d& p_LQ) const {
  return line_load_ + (p_LQ - bore_.p_LC).dot(bore_.axis_L) * line_load_slope_;
}

Vector3d BearingTraction::shear(const Vector3d& p_LQ) const {
  const Vector3d e_theta = bore_.axis_L.cross(p_LQ - bore_.p_LC).normalized();
  return axial_shear_ * bore_.axis_L + torsional_shear_ * e_theta;
}

namespace {

// Points on one line have no second moment about it; what round-off leaves
// there must not be divided by.
constexpr double kRankTolerance = 1e-12;

Vector3d solve_with_rank(const Matrix3d& second_moment, const Vector3d& rhs) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(second_moment);
  Vector3d solution = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    if (eigen.eigenvalues()[i] > kRankTolerance * eigen.eigenvalues()[2]) {
      const Vector3d direction = eigen.eigenvectors().col(i);
      solution += direction.dot(rhs) / eigen.eigenvalues()[i] * direction;
    }
  }
  return solution;
}

}  // namespace

LinearTraction::LinearTraction(const Vector3d& centroid, double area,
                               const Matrix3d& second_moment,
                               const Wrench& wrench, const Vector3d& about)
    : centroid_(centroid), mean_(wrench.force / area) {
  assert(area > 0.0);
  const Vector3d moment_about_centroid =
      wrench.moment + (about - centroid).cross(wrench.force);
  slope_ = solve_with_rank(second_moment, moment_about_centroid);
}

Vector3d LinearTraction::traction(const Vector3d& p_LQ) const {
  return mean_ + slope_.cross(p_LQ - centroid_);
}

}  // namespace clevis::loads
