#include "mechanism/element_base/acting_element.h"

#include <Eigen/Geometry>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

JointFrame frame_of(const ElementPoint& p, const ReferenceFrame& frame) {
  JointFrame result;
  if (p.body == kGround) {
    result.p_LJ = frame.R_WP.transpose() * p.p_L;
    result.R_LJ = frame.R_WP.transpose();
  } else {
    result.p_LJ = p.p_L - frame.p_LM[index(p.body)];
  }
  return result;
}

/// Angle of a line by the mean of its rates since turns are counted.
double angle_near(const ActingElement& e, const ActingState& state,
                  const Vector3d& turning) {
  const Configuration& x = state.configuration;
  const Vector3d axis =
      e.row.is_second_angle()
          ? Vector3d(x[index(e.line.b)].R * e.line.frame_b.R_LJ.col(0))
          : Vector3d(x[index(e.line.a)].R * e.line.frame_a.R_LJ.col(2));
  return e.anchor.q +
         0.5 * (e.anchor.rate + axis.dot(turning)) * (state.t - e.anchor.t);
}

}  // namespace

Matrix3d with_z_along(const Vector3d& direction) {
  return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(),
                                            direction.normalized())
      .toRotationMatrix();
}

void ActingElement::join(const ElementPoint& a, const ElementPoint& b,
                         const ReferenceFrame& frame) {
  line.a = a.body + 1;
  line.b = b.body + 1;
  line.frame_a = frame_of(a, frame);
  line.frame_b = frame_of(b, frame);
}

void ActingElement::evaluate(const ActingState& state,
                             ElementResponse& now) const {
  const Twist& a = state.twists[index(line.a)];
  const Twist& b = state.twists[index(line.b)];
  const Configuration& x = state.configuration;
  const double near =
      line.counts_turns ? angle_near(*this, state, b.w - a.w) : 0.0;
  now.placed = PlacedJoint(line, x[index(line.a)], x[index(line.b)], near);
  act(state, a, b, now);
  now.power = now.on_a.v.dot(a.v) + now.on_a.w.dot(a.w) + now.on_b.v.dot(b.v) +
              now.on_b.w.dot(b.w);
}

PlacedJoint ActingElement::placed_in(const Configuration& x) const {
  return {line, x[index(line.a)], x[index(line.b)]};
}

void ActingElement::accept(double t, const ElementResponse& now) {
  if (line.counts_turns) anchor = {now.q, now.rate, t};
}

std::array<ElementAction, 2> ActingElement::actions(
    const ElementResponse& now) const {
  const auto [to_a, to_b] = touched(now);
  const Matrix3d R_WP = R_PW.transpose();
  const auto action = [&R_WP](int slot, const Vector3d& p_J, const Vector3d& r,
                              const Vector3d& to, const SpatialForce& wrench) {
    const Vector3d about_p = wrench.w - (r + to).cross(wrench.v);
    return ElementAction{.body = slot - 1,
                         .p_W = R_WP * (p_J + to),
                         .f_W = R_WP * wrench.v,
                         .t_W = R_WP * about_p};
  };
  const PlacedJoint& placed = now.placed;
  return {action(line.a, placed.p_b - placed.d, placed.r_a, to_a, now.on_a),
          action(line.b, placed.p_b, placed.r_b, to_b, now.on_b)};
}

double ActingElement::guard_value(const ElementGuard& guard, double /*t*/,
                                  const ElementResponse& now) const {
  switch (guard.kind) {
    case ElementGuard::Kind::kDepth:
      return now.depth[index(guard.end)] - guard.level;
    case ElementGuard::Kind::kRate:
      return now.rate - guard.level;
    case ElementGuard::Kind::kPosition:
      return now.q - guard.level;
    case ElementGuard::Kind::kOwn:
      break;
  }
  return 1.0;
}

PlacedJoint::Levers ActingElement::apart(int end,
                                         const ElementResponse& now) const {
  const PlacedJoint::Levers& levers = now.levers;
  if (end == 0) return levers;
  return {.a = {-levers.a.v, -levers.a.w}, .b = {-levers.b.v, -levers.b.w}};
}

double ActingElement::apart_bias(int end, const ElementResponse& now,
                                 const Twist& a, const Twist& b) const {
  return (end == 0 ? 1.0 : -1.0) * now.placed.bias(row, a, b);
}

}  // namespace clevis::mechanism
