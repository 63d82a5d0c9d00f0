#include "loads/pressure/seat_traction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "loads/history/balance.h"

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

WallMoments full_wall(const part::Bore& bore) {
  const double l = bore.length;
  return {.length = l, .first = 0.0, .second = l * l * l / 12.0};
}

WallMoments wall_of(const part::Bore& bore, const Matrix3Xd& points,
                    const Eigen::VectorXd& weights) {
  const Eigen::RowVectorXd height =
      bore.axis_L.transpose() * (points.colwise() - bore.p_LC);
  const Eigen::VectorXd share =
      weights / (2.0 * std::numbers::pi * bore.radius);
  const WallMoments found{.length = share.sum(),
                          .first = height.dot(share),
                          .second = height.cwiseAbs2().dot(share)};
  return std::abs(found.length - bore.length) <=
                 part::kWholeWallTolerance * bore.length
             ? full_wall(bore)
             : found;
}

BearingTraction::BearingTraction(const part::Bore& bore, const Wrench& wrench,
                                 const WallMoments& wall)
    : bore_(bore) {
  assert(bore.radius > 0.0 && wall.length > 0.0);
  const Vector3d& axis = bore.axis_L;
  const double axial_force = wrench.force.dot(axis);
  const Vector3d across = wrench.force - axial_force * axis;
  // ∫ s axis × w(s) ds is the moment normal to the axis:
  // length w_0 + first w_1 = F, first w_0 + second w_1 = M × axis.
  const double lever = wall.first / wall.length;
  line_load_slope_ = (wrench.moment.cross(axis) - lever * across) /
                     (wall.second - lever * wall.first);
  line_load_ = (across - wall.first * line_load_slope_) / wall.length;
  const double area = 2.0 * std::numbers::pi * bore.radius * wall.length;
  axial_shear_ = axial_force / area;
  torsional_shear_ = wrench.moment.dot(axis) / (area * bore.radius);
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

Matrix3Xd LinearTraction::tractions(const Matrix3Xd& points) const {
  Matrix3d slope;
  slope << 0.0, -slope_.z(), slope_.y(), slope_.z(), 0.0, -slope_.x(),
      -slope_.y(), slope_.x(), 0.0;
  return (slope * (points.colwise() - centroid_)).colwise() + mean_;
}

}  // namespace clevis::loads
