#include "mechanism/force_elements/bushing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6 = BushingElement::Matrix6;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kMass = 2.0;                  // kg
const Vector3d kInertia(0.002, 0.003, 0.004);  // kg m²
const Vector3d kSeat(0.1, 0.2, 0.3);           // m

BodyDefinition block(const Vector3d& at) {
  BodyDefinition body = testing::uniform_bar("block", at, 0.0, 0.1);
  body.mass_properties.mass = kMass;
  body.mass_properties.p_LCm.setZero();
  body.mass_properties.inertia_LCm = kInertia.asDiagonal();
  return body;
}

/// A block on a bushing to ground, its frames where the block is placed.
MechanismDefinition seated_block(const BushingElement& given) {
  MechanismDefinition m;
  m.bodies = {block(kSeat)};
  BushingElement bushing = given;
  bushing.a = {kGround, kSeat};
  bushing.b = {0, Vector3d::Zero()};
  m.elements = {bushing};
  return m;
}

SimulationSettings settings(double duration, int instants) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = 1e-10;
  s.motion = MotionKind::kDynamic;
  return s;
}

/// Symmetric, positive definite, every motion coupled to every other.
Matrix6 full_stiffness() {
  Matrix6 mixed;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) mixed(i, j) = std::sin(1.0 + 7.0 * i + 3.0 * j);
  }
  Vector6 size;
  size << 1.0, 1.0, 1.0, 0.05, 0.05, 0.05;  // m
  const Matrix6 scaled =
      size.asDiagonal() * mixed * mixed.transpose() * size.asDiagonal();
  const Vector6 own = size.cwiseProduct(size);
  return 1e3 * (scaled + Matrix6(own.asDiagonal()));
}

// x'' + 2 D w x' + w² x = 0 along x, likewise about z far beyond small angles.
TEST(Bushing, Rings) {
  BushingElement bushing;
  bushing.stiffness.diagonal() << 800.0, 900.0, 700.0, 3.0, 4.0, 1.6;
  bushing.damping.diagonal() << 8.0, 0.0, 0.0, 0.0, 0.0, 0.016;
  MechanismDefinition m = seated_block(bushing);
  const double v = 0.5, w = 20.0;  // m/s, rad/s
  m.initial_bodies = {
      {.body = 0, .v_WLo = {v, 0.0, 0.0}, .w_WL = {0.0, 0.0, w}, .place = ""}};
  const Motion motion = simulate(m, settings(1.0, 21));
  const auto swing = [](double t, double rate, double stiffness, double damping,
                        double mass) {
    const double decay = 0.5 * damping / mass;
    const double ringing = std::sqrt(stiffness / mass - decay * decay);
    return rate / ringing * std::exp(-decay * t) * std::sin(ringing * t);
  };
  double largest = 0.0;
  for (const Instant& i : motion.instants) {
    const Matrix3d& R = i.bodies[0].pose.R_WL;
    const double x = swing(i.t, v, 800.0, 8.0, kMass);
    const double angle = swing(i.t, w, 1.6, 0.016, kInertia.z());
    const Vector3d off = i.bodies[0].pose.p_WL - kSeat - Vector3d(x, 0.0, 0.0);
    EXPECT_LT(off.norm(), 1e-9) << i.t;
    EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), angle, 1e-8) << i.t;
    const double energy = 0.5 * (800.0 * x * x + 1.6 * angle * angle);
    EXPECT_NEAR(i.elements[0].channels.at(1), energy, 1e-7) << i.t;
    largest = std::max(largest, std::abs(angle));
  }
  EXPECT_GT(largest, 0.7);
}

// At rest q = K⁻¹ (F, M), for turns so small that their square is nothing; the
// frame turned in both bodies alike turns K with it.
TEST(Bushing, GivesWayByItsWholeStiffness) {
  const Matrix3d R =
      Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -2.0) / 3.0).toRotationMatrix();
  BushingElement bushing;
  bushing.stiffness = full_stiffness();
  bushing.damping = 0.05 * bushing.stiffness;
  bushing.R_AJ = bushing.R_BJ = R;
  MechanismDefinition m = seated_block(bushing);
  ConstantForce push;
  push.point.body = 0;
  push.f_W = {0.02, -0.01, 0.03};
  push.t_W = {1e-4, 2e-4, -1e-4};
  m.elements.emplace_back(push);
  const Motion motion = simulate(m, settings(6.0, 3));
  Vector6 load;
  load << R.transpose() * push.f_W, R.transpose() * push.t_W;
  const Vector6 known = bushing.stiffness.ldlt().solve(load);
  const Pose& pose = motion.instants.back().bodies[0].pose;
  const Eigen::AngleAxisd turn(pose.R_WL);
  Vector6 found;
  found << R.transpose() * (pose.p_WL - kSeat),
      R.transpose() * (turn.angle() * turn.axis());
  const double turned = known.tail<3>().norm();
  EXPECT_LT(turned, 2e-3);
  EXPECT_LT((found - known).norm(), 2.0 * turned * known.norm());
  EXPECT_LT((found - known).norm(), 1e-3 * known.norm());
  const ElementState& state = motion.instants.back().elements[0];
  EXPECT_NEAR(state.effort, push.f_W.norm(), 1e-6);
  EXPECT_NEAR(state.channels.at(0), push.t_W.norm(), 0.01 * push.t_W.norm());
  EXPECT_NEAR(state.channels.at(1), 0.5 * known.dot(load),
              1e-3 * known.dot(load));
}

// Two blocks that tumble: kinetic energy and that of the bushing stay, and so
// does their common momentum.
TEST(Bushing, KeepsEnergyWhereFramesTurnFar) {
  MechanismDefinition m;
  m.bodies = {block(kSeat), block(kSeat + Vector3d(0.1, 0.0, 0.0))};
  BushingElement bushing;
  bushing.a = {0, {0.06, 0.01, 0.0}};
  bushing.b = {1, {-0.05, 0.0, 0.02}};
  bushing.stiffness = 0.1 * full_stiffness();
  m.elements = {bushing};
  m.initial_bodies = {{.body = 0,
                       .v_WLo = {0.3, -0.2, 0.1},
                       .w_WL = {15.0, -8.0, 11.0},
                       .place = ""},
                      {.body = 1,
                       .v_WLo = {-0.1, 0.4, 0.2},
                       .w_WL = {-9.0, 12.0, 4.0},
                       .place = ""}};
  const Motion motion = simulate(m, settings(1.0, 51));
  const auto energy = [](const Instant& at) {
    double sum = at.elements[0].channels.at(1);
    for (const BodyState& body : at.bodies) {
      const Vector3d w = body.pose.R_WL.transpose() * body.w_WL;
      sum += 0.5 * kMass * body.v_WLo.squaredNorm() +
             0.5 * w.dot(kInertia.cwiseProduct(w));
    }
    return sum;
  };
  const auto momentum = [](const Instant& at) {
    return Vector3d(kMass * (at.bodies[0].v_WLo + at.bodies[1].v_WLo));
  };
  const double whole = energy(motion.instants.front());
  double turned = 0.0, exchanged = 0.0;
  for (const Instant& i : motion.instants) {
    EXPECT_NEAR(energy(i), whole, 1e-7 * whole) << i.t;
    EXPECT_LT((momentum(i) - momentum(motion.instants.front())).norm(), 1e-8);
    const Matrix3d relative =
        i.bodies[0].pose.R_WL.transpose() * i.bodies[1].pose.R_WL;
    turned = std::max(turned, Eigen::AngleAxisd(relative).angle());
    exchanged = std::max(exchanged, i.elements[0].channels.at(1) / whole);
  }
  EXPECT_GT(turned, 0.5);
  EXPECT_GT(exchanged, 0.1);
}

}  // namespace
}  // namespace clevis::mechanism
