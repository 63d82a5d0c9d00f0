#include "loads/discrete_balance.h"

#include <cassert>

#include <Eigen/Geometry>

namespace clevis::loads {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

Wrench resultant(const GroupQuadrature& quadrature,
                 const Eigen::Matrix3Xd& tractions, const Vector3d& about) {
  assert(quadrature.points.cols() == tractions.cols() &&
         quadrature.weights.size() == tractions.cols());
  Wrench sum;
  for (Index q = 0; q < tractions.cols(); ++q) {
    const Vector3d force = quadrature.weights[q] * tractions.col(q);
    const Vector3d arm = quadrature.points.col(q) - about;
    sum.force += force;
    sum.moment += arm.cross(force);
  }
  return sum;
}

LinearTraction correction(const GroupQuadrature& quadrature,
                          const Eigen::Matrix3Xd& tractions,
                          const Wrench& wrench, const Vector3d& about) {
  const double area = quadrature.weights.sum();
  const Vector3d centroid = quadrature.points * quadrature.weights / area;
  Matrix3d second_moment = Matrix3d::Zero();
  for (Index q = 0; q < quadrature.weights.size(); ++q) {
    const Vector3d r = quadrature.points.col(q) - centroid;
    second_moment +=
        quadrature.weights[q] *
        (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
  const Wrench reached = resultant(quadrature, tractions, about);
  const Wrench missing{.force = wrench.force - reached.force,
                       .moment = wrench.moment - reached.moment};
  return LinearTraction(centroid, area, second_moment, missing, about);
}

void add_correction(const GroupQuadrature& quadrature, const Wrench& wrench,
                    const Vector3d& about, Matrix3Xd& tractions) {
  const LinearTraction missing =
      correction(quadrature, tractions, wrench, about);
  for (Index q = 0; q < tractions.cols(); ++q) {
    tractions.col(q) += missing.traction(quadrature.points.col(q));
  }
}

}  // namespace clevis::loads
