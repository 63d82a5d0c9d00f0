#include "support/four_bar.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

double direction(const BodyState& body) {
  return std::atan2(body.pose.R_WL(1, 0), body.pose.R_WL(0, 0));
}

void expect_freudenstein(const FourBar& l, const Instant& at) {
  const DriveState& q = at.drives[0];
  const FourBarMotion expected =
      freudenstein(l, q.position, q.rate, q.acceleration);
  const double w = std::abs(q.rate), w2 = w * w + std::abs(q.acceleration);
  const BodyState& coupler = at.bodies[1];
  const BodyState& rocker = at.bodies[2];
  EXPECT_NEAR(wrapped(direction(coupler) - expected.coupler), 0.0, 1e-12);
  EXPECT_NEAR(wrapped(direction(rocker) - expected.rocker), 0.0, 1e-12);
  EXPECT_NEAR(coupler.w_WL.z(), expected.coupler_rate, 1e-11 * w);
  EXPECT_NEAR(rocker.w_WL.z(), expected.rocker_rate, 1e-11 * w);
  EXPECT_NEAR(coupler.alpha_WL.z(), expected.coupler_acceleration, 1e-11 * w2);
  EXPECT_NEAR(rocker.alpha_WL.z(), expected.rocker_acceleration, 1e-11 * w2);
}

TEST(FourBar, TwoTurnsOfTheCrankByFreudenstein) {
  const FourBar l;
  const Motion motion =
      simulate(four_bar(l, 0.7), {.duration = 1.0, .instants = 73});
  for (const Instant& at : motion.instants) expect_freudenstein(l, at);
}

// Sixteen instants a turn: steps of 22 degrees are subdivided, not jumped.
TEST(FourBar, CoarseInstantsStayOnTheBranch) {
  const FourBar l;
  const Motion motion =
      simulate(four_bar(l, 0.7), {.duration = 1.0, .instants = 8});
  for (const Instant& at : motion.instants) expect_freudenstein(l, at);
}

TEST(FourBar, AcceleratedCrank) {
  const FourBar l;
  MechanismDefinition m = four_bar(l, 0.7);
  m.drives[0].law = DriveLaw::kSine;
  m.drives[0].amplitude = 2.0;
  m.drives[0].frequency = 1.5;
  for (const Instant& at :
       simulate(m, {.duration = 1.0, .instants = 51}).instants) {
    expect_freudenstein(l, at);
  }
}

// Placement off by centimetres and tens of degrees: assembly finds the branch
// nearest to it.
TEST(FourBar, AssemblesFromARoughPlacement) {
  const FourBar l;
  MechanismDefinition m = four_bar(l, 0.7);
  m.bodies[1].placement.p_WL += Vector3d(0.02, -0.03, 0.0);
  m.bodies[1].placement.R_WL = turned(0.3) * m.bodies[1].placement.R_WL;
  m.bodies[2].placement.R_WL = turned(-0.2) * m.bodies[2].placement.R_WL;
  expect_freudenstein(
      l, simulate(m, {.duration = 1.0, .instants = 1}).instants[0]);
}

}  // namespace
}  // namespace clevis::mechanism
