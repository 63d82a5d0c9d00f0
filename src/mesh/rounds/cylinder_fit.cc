#include "mesh/rounds/cylinder_fit.h"

#include <cmath>

#include <Eigen/Dense>

#include "base/messages/errors.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d radial(const part::Bore& bore, const Vector3d& p) {
  const Vector3d from_centre = p - bore.p_LC;
  return from_centre - from_centre.dot(bore.axis_L) * bore.axis_L;
}

/// Circle in the plane normal to the axis, by linear least squares.
void start_circle(const Matrix3Xd& points, part::Bore& bore) {
  const Vector3d mean = points.rowwise().mean();
  const Vector3d e1 = bore.axis_L.unitOrthogonal();
  const Vector3d e2 = bore.axis_L.cross(e1);
  MatrixXd A(points.cols(), 3);
  VectorXd b(points.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    const double x = (points.col(i) - mean).dot(e1);
    const double y = (points.col(i) - mean).dot(e2);
    A.row(i) << 2.0 * x, 2.0 * y, 1.0;
    b[i] = x * x + y * y;
  }
  const Vector3d s = A.colPivHouseholderQr().solve(b);
  bore.p_LC = mean + s[0] * e1 + s[1] * e2;
  bore.radius = std::sqrt(std::max(0.0, s[2] + s[0] * s[0] + s[1] * s[1]));
}

enum class Axis { kFree, kFixed };

/// Gauss–Newton on the distances from the cylinder.
void refine(const Matrix3Xd& points, Axis axis, part::Bore& bore) {
  const Vector3d mean = points.rowwise().mean();
  const Index unknowns = axis == Axis::kFree ? 5 : 3;
  for (int step = 0; step < 12; ++step) {
    // Heights from the middle keep tilt and shift of the axis apart.
    bore.p_LC += (mean - bore.p_LC).dot(bore.axis_L) * bore.axis_L;
    const Vector3d e1 = bore.axis_L.unitOrthogonal();
    const Vector3d e2 = bore.axis_L.cross(e1);
    MatrixXd J(points.cols(), unknowns);
    VectorXd residual(points.cols());
    for (Index i = 0; i < points.cols(); ++i) {
      const Vector3d q = radial(bore, points.col(i));
      const double distance = q.norm();
      const double height = (points.col(i) - bore.p_LC).dot(bore.axis_L);
      const double c1 = -q.dot(e1) / distance, c2 = -q.dot(e2) / distance;
      J(i, 0) = c1;
      J(i, 1) = c2;
      J(i, 2) = -1.0;
      if (axis == Axis::kFree) {
        J(i, 3) = c1 * height;
        J(i, 4) = c2 * height;
      }
      residual[i] = distance - bore.radius;
    }
    const VectorXd change = -J.colPivHouseholderQr().solve(residual);
    bore.p_LC += change[0] * e1 + change[1] * e2;
    bore.radius += change[2];
    if (axis == Axis::kFree) {
      bore.axis_L =
          (bore.axis_L + change[3] * e1 + change[4] * e2).normalized();
    }
    if (change.norm() < 1e-16 * bore.radius) break;
  }
}

/// Directions of the normals and how much of them lies along each, sorted.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes_of(
    const Matrix3Xd& normals) {
  const Eigen::Matrix3d spread = normals * normals.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
      spread / std::max(spread.trace(), 1e-300));
}

[[noreturn]] void refuse(const std::string& place, const char* problem) {
  throw Error("M009", place, problem,
              "Mesh the bore with at least 5 facets around (a round with at "
              "least 2), or name the group without bore_ or round_.");
}

}  // namespace

double worst_distance(const Matrix3Xd& points, const part::Bore& bore) {
  double worst = 0.0;
  for (Index i = 0; i < points.cols(); ++i) {
    worst = std::max(
        worst, std::abs(radial(bore, points.col(i)).norm() - bore.radius));
  }
  return worst;
}

void set_extent(const Matrix3Xd& points, part::Bore& bore) {
  const VectorXd heights =
      (points.colwise() - bore.p_LC).transpose() * bore.axis_L;
  bore.length = heights.maxCoeff() - heights.minCoeff();
  bore.p_LC += 0.5 * (heights.maxCoeff() + heights.minCoeff()) * bore.axis_L;
}

bool determine_axis(const Matrix3Xd& normals) {
  return modes_of(normals).eigenvalues()[1] > 1e-6;
}

CylinderFit fit_cylinder(const Matrix3Xd& points, const Matrix3Xd& normals,
                         const std::string& place) {
  if (!determine_axis(normals)) {
    refuse(place, "its faces are flat and determine no cylinder");
  }
  part::Bore bore{Vector3d::Zero(), modes_of(normals).eigenvectors().col(0),
                  0.0, 0.0};
  start_circle(points, bore);
  refine(points, Axis::kFree, bore);
  Index main_axis = 0;
  bore.axis_L.cwiseAbs().maxCoeff(&main_axis);
  if (bore.axis_L[main_axis] < 0.0) bore.axis_L = -bore.axis_L;
  double worst = worst_distance(points, bore);

  part::Bore snapped = bore;
  snapped.axis_L = Vector3d::Unit(main_axis);
  if ((snapped.axis_L - bore.axis_L).norm() < 1e-4) {
    refine(points, Axis::kFixed, snapped);
    const double snapped_worst = worst_distance(points, snapped);
    if (snapped_worst <= std::max(2.0 * worst, 1e-10 * bore.radius)) {
      bore = snapped;
      worst = snapped_worst;
    }
  }
  set_extent(points, bore);
  if (!(bore.radius > 0.0) || !bore.p_LC.allFinite() || !std::isfinite(worst)) {
    refuse(place, "its points determine no cylinder");
  }
  return {bore, worst};
}

Vector3d project(const part::Bore& cylinder, const Vector3d& p) {
  const Vector3d q = radial(cylinder, p);
  return p + (cylinder.radius / q.norm() - 1.0) * q;
}

double angle_between(const part::Bore& cylinder, const Vector3d& p,
                     const Vector3d& q) {
  const Vector3d a = radial(cylinder, p), b = radial(cylinder, q);
  return std::atan2(cylinder.axis_L.dot(a.cross(b)), a.dot(b));
}

Vector3d screw_line(const part::Bore& cylinder, const Vector3d& p,
                    const Vector3d& q, double t) {
  const Vector3d e1 = radial(cylinder, p).normalized();
  const Vector3d e2 = cylinder.axis_L.cross(e1);
  const double angle = t * angle_between(cylinder, p, q);
  const double from = (p - cylinder.p_LC).dot(cylinder.axis_L);
  const double to = (q - cylinder.p_LC).dot(cylinder.axis_L);
  return cylinder.p_LC + (from + t * (to - from)) * cylinder.axis_L +
         cylinder.radius * (std::cos(angle) * e1 + std::sin(angle) * e2);
}

}  // namespace clevis::mesh
