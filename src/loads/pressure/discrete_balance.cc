#include "loads/pressure/discrete_balance.h"

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
  // Of Σ r fᵀ the moment Σ r × f is the skew part.
  const Matrix3Xd forces = tractions * quadrature.weights.asDiagonal();
  const Matrix3d moments =
      (quadrature.points.colwise() - about) * forces.transpose();
  Wrench sum;
  sum.force = forces.rowwise().sum();
  sum.moment = {moments(1, 2) - moments(2, 1), moments(2, 0) - moments(0, 2),
                moments(0, 1) - moments(1, 0)};
  return sum;
}

DiscreteBalance::DiscreteBalance(const GroupQuadrature& quadrature,
                                 const Vector3d& about)
    : quadrature_(&quadrature),
      about_(about),
      centroid_(quadrature.points * quadrature.weights /
                quadrature.weights.sum()),
      area_(quadrature.weights.sum()),
      second_moment_(Matrix3d::Zero()) {
  for (Index q = 0; q < quadrature.weights.size(); ++q) {
    const Vector3d r = quadrature.points.col(q) - centroid_;
    second_moment_ +=
        quadrature.weights[q] *
        (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
}

LinearTraction DiscreteBalance::missing(const Wrench& wrench,
                                        const Matrix3Xd& tractions) const {
  const Wrench reached = resultant(*quadrature_, tractions, about_);
  return {centroid_,
          area_,
          second_moment_,
          {.force = wrench.force - reached.force,
           .moment = wrench.moment - reached.moment},
          about_};
}

void DiscreteBalance::correct(const Wrench& wrench,
                              Matrix3Xd& tractions) const {
  const LinearTraction rest = missing(wrench, tractions);
  tractions += rest.tractions(quadrature_->points);
}

}  // namespace clevis::loads
