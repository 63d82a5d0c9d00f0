#include "mechanism/line_elements/spring.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using testing::flywheel;
using testing::on_joint;
using testing::sampled;
using testing::sliders;

double x_of(const Instant& instant, std::size_t body) {
  return instant.bodies[body].pose.p_WL.x();
}

// Spring and damper between two points: a mass that swings about the end.
TEST(Spring, ConservesEnergyAndRingsAtItsFrequency) {
  MechanismDefinition m = sliders({2.0});
  LineElement spring;
  spring.line.kind = ElementLine::Kind::kDistance;
  spring.line.a.p_L = {-0.5, 0.0, 0.0};
  spring.line.b.body = 0;
  spring.law = SpringLaw{.stiffness = 200.0, .damping = 4.0, .free = 0.5};
  m.elements = {spring};
  m.initial_joints = {
      {.joint = 0, .position = 0.1, .rate = {}, .place = "initial"}};
  const Motion motion = simulate(m, sampled(2.0, 21, 1e-9));
  const double decay = 1.0, w = std::sqrt(100.0 - 1.0);
  for (const Instant& i : motion.instants) {
    EXPECT_NEAR(x_of(i, 0),
                0.1 * std::exp(-decay * i.t) *
                    (std::cos(w * i.t) + decay / w * std::sin(w * i.t)),
                1e-9);
    EXPECT_LT(i.power_balance_error, 1e-12);
  }
}

// In a driven motion the elements load drive and joints.
TEST(Spring, LoadsTheDriveOfADrivenMotion) {
  MechanismDefinition m = sliders({2.0});
  m.elements.push_back(on_joint(
      0, SpringLaw{.stiffness = 100.0, .damping = 3.0, .preload = 1.0}));
  m.elements.push_back(
      on_joint(0, FrictionLaw{.breakaway = 2.0, .kinetic = 1.5}));
  DriveDefinition drive;
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.1;
  drive.frequency = 1.0;
  m.drives = {drive};
  const Motion motion = simulate(m, sampled(1.0, 17, 1e-9));
  EXPECT_FALSE(motion.integration);
  for (const Instant& i : motion.instants) {
    const auto& d = i.drives[0];
    const double friction = d.rate > 0.0 ? 1.5 : -1.5;
    EXPECT_NEAR(d.effort,
                2.0 * d.acceleration + 100.0 * d.position + 3.0 * d.rate + 1.0 +
                    friction,
                1e-10);
    EXPECT_LT(i.power_balance_error, 1e-12);
  }
}

// Angles count beyond a turn: 0.5 kg m² on 2 N m/rad, from 10 rad.
TEST(Spring, TorsionCountsTurns) {
  for (const auto dimension :
       {SpaceDimension::kPlanar, SpaceDimension::kSpatial}) {
    MechanismDefinition m = flywheel(0.5);
    m.dimension = dimension;
    m.elements = {
        on_joint(0, SpringLaw{.stiffness = 2.0, .free = 1.0, .preload = 3.0})};
    m.initial_joints = {
        {.joint = 0, .position = 10.0, .rate = {}, .place = "initial"}};
    const Motion motion = simulate(m, sampled(5.0, 51, 1e-9));
    const double rest = 1.0 - 3.0 / 2.0;
    for (const Instant& i : motion.instants) {
      EXPECT_NEAR(i.elements[0].position,
                  rest + (10.0 - rest) * std::cos(2.0 * i.t), 1e-7);
    }
  }
}

}  // namespace
}  // namespace clevis::mechanism
