#include "support/landing_gear.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using namespace testing;

// The reference values are printed to three digits of a millimetre.
constexpr double kPrinted = 0.51e-6;  // [m]

Instant held(MechanismDefinition m, double lx) {
  hold(m, lx);
  return simulate(m, {.duration = 1.0, .instants = 1}).instants[0];
}

Vector3d pin(const Instant& instant, int joint) {
  return instant.joints[static_cast<std::size_t>(joint)].p_WJ;
}

double force(const Instant& instant, int joint) {
  return instant.joints[static_cast<std::size_t>(joint)].f_W.norm();
}

struct Position {
  double lx;
  Vector3d B, C, E, F;         // [mm]
  double q1, theta, cylinder;  // [deg]
};

// The worked example of the landing gear, printed to three digits
const std::vector<Position> kPositions{{160,
                                        {43.688, 133.009, 0},
                                        {43.688, 193.009, 0},
                                        {-54.100, 85.946, 0},
                                        {-210, 49.957, 0},
                                        28.360,
                                        71.817,
                                        12.999},
                                       {210,
                                        {132.678, 44.682, 0},
                                        {132.678, 104.682, 0},
                                        {-11.627, 118.863, 0},
                                        {-210, 49.957, 0},
                                        81.565,
                                        18.612,
                                        19.155},
                                       {260,
                                        {104.815, -92.811, 0},
                                        {104.815, -32.811, 0},
                                        {45.257, 99.393, 0},
                                        {-210, 49.957, 0},
                                        141.701,
                                        -41.524,
                                        10.961}};

TEST(LandingGear, PositionsOfTheReference) {
  for (const Position& expected : kPositions) {
    const Instant at = held(landing_gear(), 1e-3 * expected.lx);
    EXPECT_LT((pin(at, kB) - 1e-3 * expected.B).cwiseAbs().maxCoeff(),
              kPrinted);
    EXPECT_LT((pin(at, kC) - 1e-3 * expected.C).cwiseAbs().maxCoeff(),
              kPrinted);
    EXPECT_LT((pin(at, kE) - 1e-3 * expected.E).cwiseAbs().maxCoeff(),
              kPrinted);
    EXPECT_LT((pin(at, kF) - 1e-3 * expected.F).cwiseAbs().maxCoeff(),
              kPrinted);
  }
}

TEST(LandingGear, AnglesOfTheReference) {
  constexpr double printed = 0.51e-3;  // [deg]
  const auto direction = [](const BodyState& body) {
    return std::atan2(body.pose.R_WL(1, 0), body.pose.R_WL(0, 0)) * 180.0 /
           std::numbers::pi;
  };
  for (const Position& expected : kPositions) {
    const Instant at = held(landing_gear(), 1e-3 * expected.lx);
    EXPECT_NEAR(direction(at.bodies[kBodyDCE]), expected.theta, printed);
    EXPECT_NEAR(direction(at.bodies[kFE1]), expected.cylinder, printed);
  }
}

TEST(LandingGear, PinDistancesAreConstantOverTheStroke) {
  const Motion motion = simulate(landing_gear(), {.duration = 2.0});
  ASSERT_EQ(motion.instants.size(), 201u);
  for (const Instant& at : motion.instants) {
    const auto ratio = [&at](int a, int b, double length) {
      return std::abs((pin(at, a) - pin(at, b)).norm() / length - 1.0);
    };
    EXPECT_LT(ratio(kD, kC, kDC), 1e-9);
    EXPECT_LT(ratio(kE, kD, kED), 1e-9);
    EXPECT_LT(ratio(kE, kC, kEC), 1e-9);
    EXPECT_LT(ratio(kA, kB, kAB), 1e-9);
    EXPECT_LT(ratio(kB, kC, kBC), 1e-9);
    EXPECT_LT(ratio(kF, kE, at.drives[0].position), 1e-9);
    EXPECT_LT(at.closure_error, 1e-12);
  }
}

TEST(LandingGear, DCETurnsBy113Degrees) {
  const Motion motion = simulate(landing_gear(), {.duration = 2.0});
  double turned = 0.0;
  for (std::size_t i = 1; i < motion.instants.size(); ++i) {
    const auto& before = motion.instants[i - 1].bodies[kBodyDCE].pose.R_WL;
    const auto& now = motion.instants[i].bodies[kBodyDCE].pose.R_WL;
    const Eigen::Matrix3d step = now * before.transpose();
    turned += std::atan2(step(1, 0), step(0, 0));
  }
  // q1 of the triangle FED, independent of DD1
  const double by_triangle =
      landing_gear_angles(0.26, 0.21).q1 - landing_gear_angles(0.16, 0.21).q1;
  EXPECT_NEAR(turned, -by_triangle, 1e-12);
  EXPECT_NEAR(turned * 180.0 / std::numbers::pi, -113.34, 0.005);
}

TEST(LandingGear, VelocityRatiosOfC) {
  MechanismDefinition m = landing_gear();
  m.drives[0].law = DriveLaw::kRamp;  // so that it moves at the ends too
  m.markers.clear();
  const Motion motion = simulate(m, {.duration = 2.0});
  const auto ratio = [&motion](std::size_t i) {
    const Instant& at = motion.instants[i];
    return at.bodies[kBodyBC].v_WLo.norm() / at.drives[0].rate;
  };
  EXPECT_NEAR(ratio(0), 3.7383, 0.51e-4);
  EXPECT_NEAR(ratio(100), 2.3562, 0.51e-4);
  EXPECT_NEAR(ratio(200), 4.6559, 0.51e-4);
}

struct Reactions {
  double lx, A, C, D, E;  // [mm], [N]
};

MechanismDefinition loaded_at(double below_C) {
  MechanismDefinition m = landing_gear();
  m.gravity_W.setZero();
  m.elements = {wheel_load(below_C)};
  return m;
}

// The same example, printed to a newton
TEST(LandingGear, ReactionsUnderTheWheelLoad) {
  for (const Reactions& expected : {Reactions{160, 3739, 2638, 2970, 609},
                                    Reactions{210, 1231, 902, 1632, 1857},
                                    Reactions{260, 1558, 2140, 5213, 5029}}) {
    const Instant at = held(loaded_at(0.14), 1e-3 * expected.lx);
    EXPECT_NEAR(force(at, kA), expected.A, 0.51);
    EXPECT_NEAR(force(at, kB), expected.A, 0.51);
    EXPECT_NEAR(force(at, kC), expected.C, 0.51);
    EXPECT_NEAR(force(at, kD), expected.D, 0.51);
    EXPECT_NEAR(force(at, kE), expected.E, 0.51);
    EXPECT_NEAR(force(at, kF), expected.E, 0.51);
    // tension at 160 mm, pressure later
    const double sign = expected.lx < 200 ? -1.0 : 1.0;
    EXPECT_NEAR(at.drives[0].effort, sign * expected.E, 0.51);
  }
}

TEST(LandingGear, ReactionsUnderTheLoadAtPinC) {
  const double lx[] = {0.16, 0.21, 0.26}, D[] = {868, 2770, 5779};
  for (int i = 0; i < 3; ++i) {
    const Instant at = held(loaded_at(0.0), lx[i]);
    EXPECT_LT(force(at, kA), 1e-10);  // AB idles
    EXPECT_NEAR(force(at, kC), std::hypot(500.0, 1000.0), 1e-9);
    EXPECT_NEAR(force(at, kD), D[i], 0.51);
  }
}

// Virtual work: effort · dl = −W · dr_T, dr_T by differences of positions.
// Error h²/6 of the third derivative: relative 1e-8 for h = 10 µm.
TEST(LandingGear, CylinderForceByVirtualWork) {
  constexpr double h = 1e-5;
  const auto T = [](double lx) {
    const Instant at = held(landing_gear(), lx);
    const Pose& pose = at.bodies[kBodyBC].pose;
    return Vector3d(pose.p_WL + pose.R_WL * Vector3d(0.14, 0.0, 0.0));
  };
  for (const double lx : {0.17, 0.21, 0.25}) {
    const Vector3d rate = (T(lx + h) - T(lx - h)) / (2.0 * h);
    const double expected = -Vector3d(500.0, 1000.0, 0.0).dot(rate);
    const Instant at = held(loaded_at(0.14), lx);
    EXPECT_NEAR(at.drives[0].effort, expected, 1e-6 * std::abs(expected));
  }
}

TEST(LandingGear, PowerBalanceWithInertiaAndLoad) {
  MechanismDefinition m = landing_gear();
  m.elements = {wheel_load(0.14)};
  m.drives[0].duration = 0.05;  // inertia as large as the load
  for (const Instant& at :
       simulate(m, {.duration = 0.05, .instants = 101}).instants) {
    EXPECT_LT(at.power_balance_error, 1e-10);
  }
}

}  // namespace
}  // namespace clevis::mechanism
