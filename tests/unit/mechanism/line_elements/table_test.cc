#include "mechanism/line_elements/table.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace clevis::mechanism
