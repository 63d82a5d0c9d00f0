// What a mechanism's constraints leave open of its state.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Index ForwardDynamics::tangents(double t, const VectorXd& y, MatrixXd& T) {
  place(t, y);
  const Index columns = system_.columns();
  open_velocities(open_);
  const Index freedom = open_.cols();
  T.leftCols(2 * freedom + forces_.internal_states()).setZero();
  for (Index j = 0; j < freedom; ++j) {
    const auto open = open_.col(j);
    put_displacement(y, open, T.col(j).head(positions_));
    T.col(j) *= length_;
    T.col(freedom + j).segment(positions_, columns) = speed_scale() * open;
  }
  scales(y, scratch_);
  Index used = 2 * freedom;
  for (Index i = internal_index(); i < work_index(); ++i) {
    if (scratch_[i] == 0.0) continue;
    T(i, used++) = std::max(scratch_[i], std::abs(y[i]));
  }
  return used;
}

/// Orthonormal columns N of unknowns with J N = 0, for joints and drives.
void ForwardDynamics::open_velocities(MatrixXd& N) {
  const Index rows = system_.rows(), columns = system_.columns();
  system_.fill_jacobian(placed_, J_);
  if (rows == 0) {
    N.setIdentity(columns, columns);
    return;
  }
  row_space_.setThreshold(numerics::kRankThreshold);
  row_space_.compute(J_.topLeftCorner(rows, columns).transpose());
  const Index freedom = columns - row_space_.rank();
  N.setZero(columns, freedom);
  N.bottomRows(freedom).setIdentity();
  row_space_.householderQ().applyThisOnTheLeft(N, row_workspace_);
}

/// How positions change as bodies move by unknowns.
void ForwardDynamics::put_displacement(
    const VectorXd& y, const Eigen::Ref<const VectorXd>& unknowns,
    Eigen::Ref<VectorXd> change) const {
  if (planar_) {
    change = unknowns;
    return;
  }
  for (Index i = 0; i < positions_ / 7; ++i) {
    change.segment<3>(7 * i) = unknowns.segment<3>(6 * i);
    const Vector3d half = 0.5 / length_ * unknowns.segment<3>(6 * i + 3);
    change.segment<4>(7 * i + 3) =
        quaternion_rate(y.segment<4>(7 * i + 3), half);
  }
}

/// Between the solving frame's axes and those of each body.
void ForwardDynamics::turn(const VectorXd& y, Eigen::Ref<VectorXd> v,
                           bool to_bodies) const {
  const Index bodies = static_cast<Index>(bodies_.size()) - 1;
  for (Index i = 0; i < bodies; ++i) {
    if (planar_) {
      const double angle = (to_bodies ? -1.0 : 1.0) * y[3 * i + 2] / length_;
      const Eigen::Rotation2Dd R(angle);
      v.segment<2>(3 * i) = R * v.segment<2>(3 * i);
      v.segment<2>(positions_ + 3 * i) = R * v.segment<2>(positions_ + 3 * i);
      continue;
    }
    Eigen::Quaterniond q;
    q.coeffs() = y.segment<4>(7 * i + 3).normalized();
    if (to_bodies) q = q.conjugate();
    const Matrix3d R = q.toRotationMatrix();
    v.segment<3>(7 * i) = R * v.segment<3>(7 * i);
    Eigen::Quaterniond change;
    change.coeffs() = v.segment<4>(7 * i + 3);
    v.segment<4>(7 * i + 3) = (q * change).coeffs();
    const Index at = positions_ + 6 * i;
    v.segment<3>(at) = R * v.segment<3>(at);
    v.segment<3>(at + 3) = R * v.segment<3>(at + 3);
  }
}

}  // namespace clevis::mechanism
