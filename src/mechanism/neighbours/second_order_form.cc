#include "mechanism/neighbours/second_order_form.h"

#include <Eigen/Geometry>

#include "mechanism/joints/cross_matrix.h"

namespace clevis::mechanism {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

void SecondOrderForm::add_force(const Mover& mover, const Vector3d& f,
                                const Vector3d& r) {
  const Matrix3d outer = f * r.transpose();
  H_.block<3, 3>(mover.at + 3, mover.at + 3) +=
      f.dot(r) * Matrix3d::Identity() - 0.5 * (outer + outer.transpose());
}

void SecondOrderForm::add_moment(const Mover& a, const Mover& b,
                                 const Vector3d& t) {
  const Matrix3d half = -0.5 * cross_matrix(t);
  H_.block<3, 3>(a.at + 3, b.at + 3) += half;
  H_.block<3, 3>(b.at + 3, a.at + 3) += half.transpose();
}

void SecondOrderForm::add_line(const std::optional<Mover>& a,
                               const std::optional<Mover>& b,
                               const Vector3d& p_a, const Vector3d& p_b,
                               double tension) {
  const Vector3d line = p_b - p_a;
  const double length = line.norm();
  if (!(length > 0.0)) return;
  const Vector3d e = line / length;
  const Matrix3d across =
      tension / length * (Matrix3d::Identity() - e * e.transpose());
  const MatrixXd relative = relative_displacement(a, b, p_a, p_b);
  H_ += relative.transpose() * across * relative;
}

void SecondOrderForm::add_turning(const Mover& a, const std::optional<Mover>& b,
                                  const Vector3d& p, const Vector3d& f) {
  const MatrixXd product = cross_matrix(f) * relative_displacement(a, b, p, p);
  H_.middleRows<3>(a.at + 3) -= product;
  H_.middleCols<3>(a.at + 3) -= product.transpose();
}

MatrixXd SecondOrderForm::relative_displacement(const std::optional<Mover>& a,
                                                const std::optional<Mover>& b,
                                                const Vector3d& p_a,
                                                const Vector3d& p_b) const {
  MatrixXd relative = MatrixXd::Zero(3, H_.cols());
  const auto add = [&](const std::optional<Mover>& mover, const Vector3d& p,
                       double sign) {
    if (!mover) return;
    relative.middleCols<3>(mover->at) += sign * Matrix3d::Identity();
    relative.middleCols<3>(mover->at + 3) -= sign * cross_matrix(p - mover->p);
  };
  add(a, p_a, -1.0);
  add(b, p_b, 1.0);
  return relative;
}

}  // namespace clevis::mechanism
