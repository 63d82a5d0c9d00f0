#include "loads/pressure/face_pressure.h"

#include "loads/history/balance.h"

namespace clevis::loads {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

Vector3d mean_normal(const Vector3d& area_vector, double area) {
  return area_vector.norm() < kOpenFace * area ? Vector3d(Vector3d::Zero())
                                               : area_vector.normalized();
}

Matrix3Xd face_pressure(const GroupQuadrature& quadrature,
                        const Matrix3Xd& outward, const Vector3d& force) {
  constexpr double kFlat = 1e-9;
  const Vector3d area_vector = outward * quadrature.weights;
  const double area = quadrature.weights.sum();
  const Vector3d normal = mean_normal(area_vector, area);
  if (normal.isZero(0.0) || area_vector.norm() > (1.0 - kFlat) * area) {
    return Matrix3Xd::Zero(3, outward.cols());
  }
  return force.dot(normal) / area_vector.norm() * outward;
}

}  // namespace clevis::loads
