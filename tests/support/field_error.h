#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Core>

#include "stress/field/stress_history.h"

namespace clevis::support {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Exact displacement [m] and stress (xx, yy, zz, xy, yz, xz) [Pa] at a point.
struct ExactField {
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> displacement;
  std::function<Vector6d(const Eigen::Vector3d&)> stress;
};

/// Root mean square errors over all lattice points, relative to the largest
/// exact value.
struct FieldError {
  double displacement{}, stress{};
};

inline FieldError field_error(const stress::InstantField& field,
                              const ExactField& exact) {
  double u_error = 0.0;
  double u_scale = 0.0;
  double s_error = 0.0;
  double s_scale = 0.0;
  double count = 0.0;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q, ++count) {
      const Eigen::Vector3d at = field.points[c].row(q);
      const Vector6d s = exact.stress(at);
      s_error += (field.stress[c].row(q).transpose() - s).squaredNorm();
      s_scale = std::max(s_scale, s.norm());
      if (!exact.displacement) continue;
      const Eigen::Vector3d u = exact.displacement(at);
      u_error += (field.displacement[c].row(q).transpose() - u).squaredNorm();
      u_scale = std::max(u_scale, u.norm());
    }
  }
  FieldError error{0.0, std::sqrt(s_error / count) / s_scale};
  if (u_scale > 0.0) error.displacement = std::sqrt(u_error / count) / u_scale;
  return error;
}

/// Largest difference of any stress component anywhere [Pa].
inline double worst_stress_error(const stress::InstantField& field,
                                 const ExactField& exact) {
  double worst = 0.0;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      worst = std::max(worst, (field.stress[c].row(q).transpose() -
                               exact.stress(field.points[c].row(q)))
                                  .cwiseAbs()
                                  .maxCoeff());
    }
  }
  return worst;
}

/// Cartesian stress from polar components rr, θθ, rθ and zz at angle θ.
inline Vector6d from_polar(double rr, double tt, double rt, double zz,
                           double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Vector6d stress;
  stress << rr * c * c + tt * s * s - 2 * rt * s * c,
      rr * s * s + tt * c * c + 2 * rt * s * c, zz,
      (rr - tt) * s * c + rt * (c * c - s * s), 0.0, 0.0;
  return stress;
}

/// Stress component along the circle about the origin at a point.
inline double hoop(const Eigen::MatrixXd& stress, Eigen::Index row,
                   double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return stress(row, 0) * s * s + stress(row, 1) * c * c -
         2.0 * stress(row, 3) * s * c;
}

}  // namespace clevis::support
