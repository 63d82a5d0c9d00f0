// States of ForwardDynamics: from and to bodies, scales.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "base/index.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Round-off of accelerations is that over the smallest pivot: motions that
// come near change points are not the better for steps beyond that.
constexpr double kRoundOff = 1e-16, kNearRank = 1e-11;

}  // namespace

VectorXd ForwardDynamics::start(const Configuration& x) {
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    turns_[j] = {x.angle(j), 0.0, 0.0};
  }
  VectorXd y = VectorXd::Zero(size());
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (planar_) {
      const Matrix3d turn = x[i].R * bodies_[i].R_start.transpose();
      const double angle = std::atan2(turn(1, 0), turn(0, 0));
      y.segment<3>(static_cast<Index>(3 * (i - 1))) =
          Vector3d(x[i].p.x(), x[i].p.y(), length_ * angle);
    } else {
      const auto at = static_cast<Index>(7 * (i - 1));
      y.segment<3>(at) = x[i].p;
      y.segment<4>(at + 3) = x[i].q.coeffs();
    }
  }
  forces_.start_internal(x, y.data() + internal_index());
  for (std::size_t j = 0; planar_ && j < turns_.size(); ++j) {
    turns_[j].plane_angle = plane_angle(frame_.joints[j], y);
  }
  return y;
}

void ForwardDynamics::place(double t, const VectorXd& y) {
  u_.setZero();  // rotors turn as their joints do
  u_.head(system_.columns()) = y.segment(positions_, system_.columns());
  for (std::size_t i = 1; i < x_.size(); ++i) {
    if (planar_) {
      const auto at = static_cast<Index>(3 * (i - 1));
      x_[i].p.head<2>() = y.segment<2>(at);
      const double angle = y[at + 2] / length_;
      const double c = std::cos(angle), s = std::sin(angle);
      const Matrix3d& R = bodies_[i].R_start;
      x_[i].R.row(0) = c * R.row(0) - s * R.row(1);
      x_[i].R.row(1) = s * R.row(0) + c * R.row(1);
      twists_[i].v.head<2>() = u_.segment<2>(at);
      twists_[i].w.z() = u_[at + 2] / length_;
    } else {
      const auto at = static_cast<Index>(7 * (i - 1));
      x_[i].p = y.segment<3>(at);
      x_[i].q.coeffs() = y.segment<4>(at + 3).normalized();
      x_[i].R = x_[i].q.toRotationMatrix();
      const auto u = static_cast<Index>(6 * (i - 1));
      twists_[i].v = u_.segment<3>(u);
      twists_[i].w = u_.segment<3>(u + 3) / length_;
      mass_.set_full(static_cast<int>(2 * i - 1),
                     x_[i].R * bodies_[i].turn_factor,
                     bodies_[i].turn_root * x_[i].R.transpose());
    }
  }
  count_turns(t, y);
  system_.place(x_, placed_);
}

void ForwardDynamics::put_body(std::size_t slot, const BodyPlacement& placement,
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

bool ForwardDynamics::has_joints_alone() const {
  return following_.empty() && !forces_.any_sticks();
}

void ForwardDynamics::put_position_rates(const VectorXd& y,
                                         VectorXd& rates) const {
  if (planar_) rates.head(positions_) = u_.head(positions_);
  for (std::size_t i = 1; i < x_.size() && !planar_; ++i) {
    const auto at = static_cast<Index>(7 * (i - 1));
    rates.segment<3>(at) = twists_[i].v;
    rates.segment<4>(at + 3) =
        quaternion_rate(y.segment<4>(at + 3), 0.5 * twists_[i].w);
  }
}

/// Angles near the true ones, which say how often a joint has turned: in the
/// plane the bodies' own angles tell, in space the rates since the last
/// accepted state.
void ForwardDynamics::count_turns(double t, const VectorXd& y) {
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    if (!traits(frame_.joints[j].type).turns_about_z) continue;
    x_.angles[j] = turns_[j].angle + turned_since(j, t, y);
  }
  if (!planar_) return;
  for (const PlaneAngle& known : plane_angles_) {
    const double turned = plane_angle(frame_.joints[known.joint], y) -
                          turns_[known.joint].plane_angle;
    forces_.anchor(known.element, known.accepted + turned, 0.0, t);
  }
}

void ForwardDynamics::anchor_turns(double t, const Configuration& x) {
  accepted_at_ = t;
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    turns_[j] = {x.angles[j], 0.0, 0.0};
  }
}

double ForwardDynamics::turned_since(std::size_t j, double t,
                                     const VectorXd& y) const {
  const JointModel& joint = frame_.joints[j];
  const Turn& turn = turns_[j];
  if (planar_) return plane_angle(joint, y) - turn.plane_angle;
  const Vector3d w = twists_[index(joint.b)].w - twists_[index(joint.a)].w;
  const Vector3d axis = x_[index(joint.a)].R * joint.frame_a.R_LJ.col(2);
  return 0.5 * (turn.rate + axis.dot(w)) * (t - accepted_at_);
}

/// Angle of b against a about the joint's axis, from the unknowns.
double ForwardDynamics::plane_angle(const JointModel& joint,
                                    const VectorXd& y) const {
  const auto angle = [&](int slot) {
    return slot == 0 ? 0.0 : y[3 * (slot - 1) + 2] / length_;
  };
  const Vector3d axis =
      frame_.placement[index(joint.a)].R * joint.frame_a.R_LJ.col(2);
  return axis.z() * (angle(joint.b) - angle(joint.a));
}

void ForwardDynamics::accept(double t, const VectorXd& y) {
  accepted_at_ = t;
  forces_.accept(t);
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    const JointModel& joint = frame_.joints[j];
    if (!traits(joint.type).turns_about_z) continue;
    const Vector3d w = twists_[index(joint.b)].w - twists_[index(joint.a)].w;
    turns_[j] = {placed_[j].turned(), placed_[j].axes_a.col(2).dot(w),
                 planar_ ? plane_angle(joint, y) : 0.0};
  }
  for (PlaneAngle& known : plane_angles_) {
    known.accepted = forces_.element(known.element).q;
  }
}

void ForwardDynamics::communicate(double t, const VectorXd& y) {
  if (forces_.next_communication() > t) return;
  rate(t, y, scratch_);
  forces_.communicate(t);
}

void ForwardDynamics::note_speed(const VectorXd& y) {
  const double speed =
      y.segment(positions_, system_.columns()).lpNorm<Eigen::Infinity>();
  // from rest: the speed that the acceleration reaches over the length
  const double reached =
      std::sqrt(length_ * acceleration_.lpNorm<Eigen::Infinity>());
  speed_ = std::max({slowest_, speed_, speed, speed_ > 0.0 ? 0.0 : reached});
  // well above what steps may err by
  const double slack = 10.0 * tolerance_ * speed_;
  // clearly beyond what counts as rest
  const double leaving = std::max(1e-3 * slack, 1e-8 * speed_);
  forces_.set_slack(slack, leaving, length_, slowest_ / length_);
  lowest_pivot_ = std::min(lowest_pivot_, mass_.smallest_pivot());
}

void ForwardDynamics::scales(const VectorXd& y, VectorXd& scales) const {
  scales.head(positions_).setConstant(length_);
  for (Index at = 3; !planar_ && at < positions_; at += 7) {
    scales.segment<4>(at).setConstant(0.5);  // of quaternions: a turn of 1
  }
  scales.segment(positions_, system_.columns()).setConstant(speed_scale());
  forces_.internal_scales(y.data() + internal_index(),
                          scales.data() + internal_index());
  scales[work_index()] = 0.0;
}

void ForwardDynamics::error_weights(const VectorXd& y,
                                    VectorXd& weights) const {
  scales(y, weights);
  const double tolerance =
      std::max(tolerance_, std::min(kRoundOff / lowest_pivot_, kNearRank));
  weights.head(work_index()) =
      (tolerance * weights.head(work_index())).cwiseInverse();
}

double ForwardDynamics::kinetic_energy(const VectorXd& y) {
  place(accepted_at_, y);
  double energy = 0.0;
  for (std::size_t i = 1; i < x_.size(); ++i) {
    const Vector3d w_L = x_[i].R.transpose() * twists_[i].w;
    energy += 0.5 * applied_.mass(i) * twists_[i].v.squaredNorm() +
              0.5 * w_L.dot(bodies_[i].inertia * w_L);
  }
  for (std::size_t k = 0; k < rotors_.size(); ++k) {
    if (rotors_[k] < 0) continue;
    const double turn = forces_.joint_rate(k, placed_, twists_);
    energy += 0.5 * forces_.inertia(k) * turn * turn;
  }
  return energy;
}

}  // namespace clevis::mechanism
