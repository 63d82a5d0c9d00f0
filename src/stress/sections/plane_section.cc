#include "stress/sections/plane_section.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Inverse of the second moments in the directions that the face has.
Matrix3d inverse_in_plane(const Matrix3d& moments) {
  constexpr double kNone = 1e-9;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(moments);
  Vector3d inverse = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (axes.eigenvalues()[k] > kNone * axes.eigenvalues()[2]) {
      inverse[k] = 1.0 / axes.eigenvalues()[k];
    }
  }
  return axes.eigenvectors() * inverse.asDiagonal() *
         axes.eigenvectors().transpose();
}

}  // namespace

std::optional<PlaneSection> plane_section(const elasticity::GroupTrace& trace) {
  constexpr double kPlane = 1e-6;
  const Matrix3Xd& points = trace.quadrature.points;
  const Eigen::VectorXd& weights = trace.quadrature.weights;
  if (weights.size() == 0) return std::nullopt;
  PlaneSection section;
  section.area = weights.sum();
  section.centroid = points * weights / section.area;
  section.normal = (trace.outward * weights).normalized();
  const Matrix3Xd arms = points.colwise() - section.centroid;
  const double size = arms.colwise().norm().maxCoeff();
  const Eigen::RowVectorXd along = section.normal.transpose() * arms;
  const bool is_plane =
      along.cwiseAbs().maxCoeff() <= kPlane * size &&
      (trace.outward.colwise() - section.normal).colwise().norm().maxCoeff() <=
          kPlane;
  if (!is_plane) return std::nullopt;
  const Matrix3d moments = arms * weights.asDiagonal() * arms.transpose();
  section.polar = moments.trace();
  section.flexibility = inverse_in_plane(moments);
  return section;
}

Eigen::VectorXd nominal_stress(const PlaneSection& section,
                               const Matrix3Xd& force, const Matrix3Xd& moment,
                               const Matrix3Xd& points) {
  const Matrix3Xd arms = points.colwise() - section.centroid;
  const Eigen::ArrayXd far = arms.colwise().norm().transpose().array();
  Eigen::VectorXd nominal(force.cols());
  for (Index i = 0; i < force.cols(); ++i) {
    const Vector3d n = section.normal, f = force.col(i), m = moment.col(i);
    const double axial = f.dot(n) / section.area;
    const double shear = (f - f.dot(n) * n).norm() / section.area;
    const Vector3d slope = section.flexibility * n.cross(m);
    const Eigen::ArrayXd bent =
        axial + (slope.transpose() * arms).transpose().array();
    const double twist = m.dot(n) / section.polar;
    const double at_nodes =
        (bent.square() + 3.0 * (twist * far).square()).maxCoeff();
    nominal[i] =
        std::sqrt(std::max(at_nodes, axial * axial + 3.0 * shear * shear));
  }
  return nominal;
}

}  // namespace clevis::stress
