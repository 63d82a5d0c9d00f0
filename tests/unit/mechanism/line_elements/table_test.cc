#include "mechanism/line_elements/table.h"

#include <gtest/gtest.h>

#include "mechanism/element_base/acting_element.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "mechanism/neighbours/neighbours.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using testing::flywheel;
using testing::on_joint;
using testing::sampled;

// Torque linear in time between the table's points, constant outside: exact
// at any tolerance where steps end at the bends.
TEST(Table, TurnsAFlywheel) {
  MechanismDefinition m = flywheel(0.5);
  m.elements = {
      on_joint(0, TableLaw{.times = {0.5, 1.5}, .efforts = {1.0, 3.0}})};
  const Motion motion = simulate(m, sampled(2.0, 5, 1e-4));
  // speed: 0.5 s at 2 rad/s², 1 s at 4 on average, 0.5 s at 6
  EXPECT_NEAR(motion.instants[4].bodies[0].w_WL.z(), 8.0, 1e-12);
  EXPECT_NEAR(motion.instants[4].elements[0].position,
              0.25 + (1.0 + 1.0 + 4.0 / 6.0) + (0.5 * 5.0 + 3.0 * 0.25), 1e-11);
}

// On a bend and at an end it holds as the softer side, beyond not at all.
TEST(Table, OnABendTheSofterSideCounts) {
  MechanismDefinition m = flywheel(0.5);
  m.elements = {on_joint(0, TableLaw{.efforts = {3.0, 0.0, -5.0, -4.0},
                                     .positions = {-1.0, 0.0, 1.0, 2.0}})};
  const SolvingFrame frame = frame_at_centres(m);
  Instant instant;
  instant.bodies.resize(1);
  const Configuration x = configuration_at(frame, instant);
  const auto table = place(m.elements[0], frame);
  const auto stiffness = [&](double position) {
    const auto spring = table->spring(x, {.position = position});
    return spring.directions.empty() ? 0.0 : spring.stiffness(0, 0);
  };
  EXPECT_EQ(stiffness(-0.5), 3.0);
  EXPECT_EQ(stiffness(0.0), 3.0);
  EXPECT_EQ(stiffness(-1e-12), 3.0);
  EXPECT_EQ(stiffness(0.5), 5.0);
  EXPECT_EQ(stiffness(1.0), -1.0);
  EXPECT_EQ(stiffness(-1.0), 0.0);
  EXPECT_EQ(stiffness(2.0), -1.0);
  EXPECT_EQ(stiffness(2.1), 0.0);
}

}  // namespace
}  // namespace clevis::mechanism
