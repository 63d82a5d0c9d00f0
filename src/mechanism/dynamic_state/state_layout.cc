#include "mechanism/dynamic_state/state_layout.h"

#include <cmath>

#include <Eigen/Geometry>

#include "base/values/index.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

StateLayout::StateLayout(const SolvingFrame& frame, int internal_states)
    : frame_(frame),
      planar_(frame.planar),
      length_(frame.length),
      bodies_(static_cast<Index>(frame.placement.size()) - 1),
      positions_(bodies_ * (planar_ ? 3 : 7)),
      velocities_(bodies_ * (planar_ ? 3 : 6)),
      internal_states_(internal_states) {}

void StateLayout::read(const VectorXd& y, MechanismState& state) const {
  VectorXd& u = state.speeds;
  u.setZero();  // rotors turn as their joints do
  u.head(velocities_) = y.segment(positions_, velocities_);
  for (std::size_t i = 1; i < state.x.size(); ++i) {
    BodyPlacement& body = state.x[i];
    Twist& twist = state.twists[i];
    if (planar_) {
      const auto at = static_cast<Index>(3 * (i - 1));
      body.p.head<2>() = y.segment<2>(at);
      const double angle = y[at + 2] / length_;
      const double c = std::cos(angle), s = std::sin(angle);
      const Matrix3d& R = frame_.placement[i].R;
      body.R.row(0) = c * R.row(0) - s * R.row(1);
      body.R.row(1) = s * R.row(0) + c * R.row(1);
      twist.v.head<2>() = u.segment<2>(at);
      twist.w.z() = u[at + 2] / length_;
    } else {
      const auto at = static_cast<Index>(7 * (i - 1));
      body.p = y.segment<3>(at);
      body.q.coeffs() = y.segment<4>(at + 3).normalized();
      body.R = body.q.toRotationMatrix();
      const auto v = static_cast<Index>(6 * (i - 1));
      twist.v = u.segment<3>(v);
      twist.w = u.segment<3>(v + 3) / length_;
    }
  }
}

double StateLayout::plane_angle(const JointModel& joint,
                                const VectorXd& y) const {
  const auto angle = [&](int slot) {
    return slot == 0 ? 0.0 : y[3 * (slot - 1) + 2] / length_;
  };
  const Vector3d axis =
      frame_.placement[index(joint.a)].R * joint.frame_a.R_LJ.col(2);
  return axis.z() * (angle(joint.b) - angle(joint.a));
}

void StateLayout::put_positions(const Configuration& x, VectorXd& y) const {
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (planar_) {
      const Matrix3d turn = x[i].R * frame_.placement[i].R.transpose();
      const double angle = std::atan2(turn(1, 0), turn(0, 0));
      y.segment<3>(static_cast<Index>(3 * (i - 1))) =
          Vector3d(x[i].p.x(), x[i].p.y(), length_ * angle);
    } else {
      const auto at = static_cast<Index>(7 * (i - 1));
      y.segment<3>(at) = x[i].p;
      y.segment<4>(at + 3) = x[i].q.coeffs();
    }
  }
}

void StateLayout::put_body(std::size_t slot, const BodyPlacement& placement,
                           const Twist& twist, const VectorXd& y_before,
                           double turned, VectorXd& y) const {
  const auto i = static_cast<Index>(slot - 1);
  if (planar_) {
    y.segment<2>(3 * i) = placement.p.head<2>();
    y[3 * i + 2] = y_before[3 * i + 2] + length_ * turned;
    y.segment<2>(positions_ + 3 * i) = twist.v.head<2>();
    y[positions_ + 3 * i + 2] = length_ * twist.w.z();
    return;
  }
  y.segment<3>(7 * i) = placement.p;
  y.segment<4>(7 * i + 3) = Eigen::Quaterniond(placement.R).coeffs();
  y.segment<3>(positions_ + 6 * i) = twist.v;
  y.segment<3>(positions_ + 6 * i + 3) = length_ * twist.w;
}

void StateLayout::move(VectorXd& y, const VectorXd& change) const {
  if (planar_) {
    y.head(positions_) += change.head(positions_);
    return;
  }
  for (Index i = 0; i < bodies_; ++i) {
    BodyPlacement body;
    body.p = y.segment<3>(7 * i);
    body.q.coeffs() = y.segment<4>(7 * i + 3);
    body.move(change.segment<3>(6 * i), change.segment<3>(6 * i + 3) / length_);
    y.segment<3>(7 * i) = body.p;
    y.segment<4>(7 * i + 3) = body.q.coeffs();
  }
}

void StateLayout::put_position_rates(const VectorXd& y,
                                     const MechanismState& state,
                                     VectorXd& rates) const {
  if (planar_) rates.head(positions_) = state.speeds.head(positions_);
  for (std::size_t i = 1; i < state.x.size() && !planar_; ++i) {
    const auto at = static_cast<Index>(7 * (i - 1));
    rates.segment<3>(at) = state.twists[i].v;
    rates.segment<4>(at + 3) =
        quaternion_rate(y.segment<4>(at + 3), 0.5 * state.twists[i].w);
  }
}

void StateLayout::put_displacement(const VectorXd& y,
                                   const Eigen::Ref<const VectorXd>& unknowns,
                                   Eigen::Ref<VectorXd> change) const {
  if (planar_) {
    change = unknowns;
    return;
  }
  for (Index i = 0; i < bodies_; ++i) {
    change.segment<3>(7 * i) = unknowns.segment<3>(6 * i);
    const Vector3d half = 0.5 / length_ * unknowns.segment<3>(6 * i + 3);
    change.segment<4>(7 * i + 3) =
        quaternion_rate(y.segment<4>(7 * i + 3), half);
  }
}

void StateLayout::to_axes(const VectorXd& y, Eigen::Ref<VectorXd> v) const {
  turn(y, Axes::kOfBodies, v);
}

void StateLayout::from_axes(const VectorXd& y, Eigen::Ref<VectorXd> v) const {
  turn(y, Axes::kOfFrame, v);
}

void StateLayout::turn(const VectorXd& y, Axes to,
                       Eigen::Ref<VectorXd> v) const {
  for (Index i = 0; i < bodies_; ++i) {
    if (planar_) {
      const double sense = to == Axes::kOfBodies ? -1.0 : 1.0;
      const Eigen::Rotation2Dd R(sense * y[3 * i + 2] / length_);
      v.segment<2>(3 * i) = R * v.segment<2>(3 * i);
      v.segment<2>(positions_ + 3 * i) = R * v.segment<2>(positions_ + 3 * i);
      continue;
    }
    Eigen::Quaterniond q;
    q.coeffs() = y.segment<4>(7 * i + 3).normalized();
    if (to == Axes::kOfBodies) q = q.conjugate();
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

void StateLayout::add_lever(int slot, const SpatialForce& lever,
                            VectorXd& force) const {
  if (slot == 0) return;
  if (planar_) {
    const Index at = 3 * (slot - 1);
    force.segment<2>(at) += lever.v.head<2>();
    force[at + 2] += lever.w.z() / length_;
  } else {
    const Index at = 6 * (slot - 1);
    force.segment<3>(at) += lever.v;
    force.segment<3>(at + 3) += lever.w / length_;
  }
}

}  // namespace clevis::mechanism
