#include "mechanism/line_elements/stop.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using testing::on_joint;
using testing::sampled;
using testing::sliders;

// Both ends of a stop: elastic bounces between walls 0.2 m apart.
TEST(Stop, BouncesBetweenBothEnds) {
  MechanismDefinition m = sliders({1.0});
  m.elements = {on_joint(
      0, StopLaw{.lower = -0.1, .upper = 0.1, .contact = {.stiffness = 1e6}})};
  m.initial_joints = {
      {.joint = 0, .position = 0.0, .rate = 1.0, .place = "initial"}};
  const Motion motion = simulate(m, sampled(1.0, 11, 1e-9));
  const double inside = M_PI / 1e3;  // half a period of 1 kg on 1e6 N/m
  ASSERT_EQ(motion.events.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) {
    const auto bounce = static_cast<double>(k / 2);
    EXPECT_NEAR(motion.events[k].t,
                0.1 + bounce * (0.2 + inside) + (k % 2 == 1 ? inside : 0.0),
                1e-10);
    EXPECT_EQ(motion.events[k].what, k % 2 == 0 ? "press" : "release");
  }
}

}  // namespace
}  // namespace clevis::mechanism
