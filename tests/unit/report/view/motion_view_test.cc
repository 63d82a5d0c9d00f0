#include "report/view/motion_view.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "report/view/mechanism_energy.h"

namespace clevis::report {
namespace {

/// A body, a joint with a sharp peak between uniform instants.
MotionView peaked(std::size_t instants, std::size_t peak) {
  MotionView view;
  view.definition.joints.resize(1);
  for (std::size_t i = 0; i < instants; ++i) {
    mechanism::Instant instant;
    instant.t = static_cast<double>(i);
    instant.joints.resize(1);
    instant.joints[0].f_W.x() = i == peak ? -9.0 : 1.0;
    view.motion.instants.push_back(instant);
  }
  return view;
}

TEST(KeptInstants, AreAllWhereThereAreFew) {
  EXPECT_EQ(kept_instants(peaked(40, 7), 40).size(), 40U);
}

TEST(KeptInstants, HoldEndsPeaksAndWorstTimesOfMany) {
  MotionView view = peaked(1000, 7);
  view.worst_times = {501.2};
  const auto kept = kept_instants(view, 11);
  EXPECT_LE(kept.size(), 16U);
  for (const std::size_t wanted : {0U, 6U, 7U, 8U, 501U, 999U}) {
    EXPECT_TRUE(std::ranges::binary_search(kept, wanted)) << wanted;
  }
}

/// A force that rises slowly and has a blow of 5 instants.
MotionView struck(std::size_t instants, std::size_t at) {
  MotionView view;
  view.definition.joints.resize(1);
  for (std::size_t i = 0; i < instants; ++i) {
    mechanism::Instant instant;
    instant.t = static_cast<double>(i);
    instant.joints.resize(1);
    const double away =
        std::abs(static_cast<double>(i) - static_cast<double>(at));
    instant.joints[0].f_W.x() =
        1e-3 * instant.t + std::max(0.0, 10.0 * (1.0 - away / 5.0));
    view.motion.instants.push_back(instant);
  }
  return view;
}

TEST(KeptInstants, HoldTheFootAndTopOfABlow) {
  const auto kept = kept_instants(struck(1000, 333), 11);
  EXPECT_LE(kept.size(), 17U);
  for (const std::size_t wanted : {328U, 333U, 338U}) {
    EXPECT_TRUE(std::ranges::binary_search(kept, wanted)) << wanted;
  }
}

TEST(KeptInstants, OfNoMotionAreNone) {
  EXPECT_TRUE(kept_instants({}, 10).empty());
}

// A rod of 3 kg and 2 m turns about its end, at the origin, with 4 rad/s:
// ½ (m l²/3) ω² = 32 J; raised by g l/2 sin 30°.
TEST(MechanismEnergy, IsThatOfATurningRod) {
  mechanism::MechanismDefinition definition;
  definition.gravity_W = {0.0, -10.0, 0.0};
  definition.bodies.resize(1);
  auto& mass = definition.bodies[0].mass_properties;
  mass.mass = 3.0;
  mass.p_LCm = {1.0, 0.0, 0.0};
  mass.inertia_LCm.diagonal() << 0.0, 1.0, 1.0;  // m l²/12
  mechanism::Instant instant;
  instant.bodies.resize(1);
  auto& body = instant.bodies[0];
  const double c = std::sqrt(0.75), s = 0.5;
  body.pose.R_WL << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  body.w_WL = {0.0, 0.0, 4.0};
  const MechanismEnergy energy = mechanism_energy(definition, instant);
  EXPECT_NEAR(energy.kinetic, 32.0, 1e-12);
  EXPECT_NEAR(energy.potential, 15.0, 1e-12);
}

}  // namespace
}  // namespace clevis::report
