#include "report/summary/mechanism_summary.h"

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

using namespace mechanism;

/// Three instants of a slider drive and a turning drive with known peaks.
struct Fixture {
  MechanismDefinition definition;
  Structure structure;
  Motion motion;

  Fixture() {
    definition.joints.resize(2);
    definition.joints[0].name = "cylinder";
    definition.joints[0].type = JointType::kPrismatic;
    definition.joints[1].name = "hinge";
    definition.joints[1].type = JointType::kRevolute;
    definition.drives.resize(2);
    definition.drives[0].joint = 1;
    definition.drives[1].joint = 0;
    structure.mobility = 2;
    structure.redundant = 3;
    motion.instants.resize(3);
    for (std::size_t i = 0; i < 3; ++i) {
      Instant& instant = motion.instants[i];
      instant.t = 0.5 * static_cast<double>(i);
      instant.joints.resize(2);
      instant.drives.resize(2);
    }
    motion.instants[1].joints[0].f_W = {-3.0, 0.0, 4.0};
    motion.instants[2].joints[0].f_W = {1.0, 1.0, 1.0};
    motion.instants[2].joints[1].t_W = {0.0, -2.0, 0.0};
    motion.instants[0].drives[0].effort = 6.0;
    motion.instants[2].drives[0].effort = -7.0;
    motion.instants[1].drives[1].effort = 9.0;
    motion.instants[1].closure_error = 1e-12;
    motion.instants[2].power_balance_error = 1e-11;
  }
};

TEST(MechanismSummary, PeaksAreMagnitudesWithTheirInstants) {
  const Fixture f;
  const auto summary = summarise(f.definition, f.structure, f.motion);
  ASSERT_EQ(summary.joints.size(), 2u);
  EXPECT_EQ(summary.joints[0].name, "cylinder");
  EXPECT_DOUBLE_EQ(summary.joints[0].force.value, 5.0);  // 3-4-5
  EXPECT_EQ(summary.joints[0].force.at, 0.5);
  EXPECT_EQ(summary.joints[0].moment.value, 0.0);
  EXPECT_EQ(summary.joints[1].force.value, 0.0);
  EXPECT_EQ(summary.joints[1].moment.value, 2.0);
  EXPECT_EQ(summary.joints[1].moment.at, 1.0);
}

TEST(MechanismSummary, DrivesCarryTheirJointAndItsKindOfEffort) {
  const Fixture f;
  const auto summary = summarise(f.definition, f.structure, f.motion);
  ASSERT_EQ(summary.drives.size(), 2u);
  EXPECT_EQ(summary.drives[0].name, "hinge");
  EXPECT_EQ(summary.drives[0].kind, EffortKind::kTorque);
  EXPECT_EQ(summary.drives[0].effort.value, 7.0);
  EXPECT_EQ(summary.drives[0].effort.at, 1.0);
  EXPECT_EQ(summary.drives[1].name, "cylinder");
  EXPECT_EQ(summary.drives[1].kind, EffortKind::kForce);
  EXPECT_EQ(summary.drives[1].effort.value, 9.0);
}

TEST(MechanismSummary, CountsAndErrorsAreTheLargest) {
  const Fixture f;
  const auto summary = summarise(f.definition, f.structure, f.motion);
  EXPECT_EQ(summary.mobility, 2);
  EXPECT_EQ(summary.redundant_constraints, 3);
  EXPECT_EQ(summary.instants, 3);
  EXPECT_EQ(summary.max_closure_error, 1e-12);
  EXPECT_EQ(summary.max_power_balance_error, 1e-11);
}

TEST(MechanismSummary, ChangePointsNameTheLargestCompliantForce) {
  Fixture f;
  f.motion.instants[1].is_change_point = true;
  f.motion.change_points = {{0.0, 1.0, 0.5, f.motion.instants[1]},
                            {0.5, 1.0, 0.75, std::nullopt}};
  const auto summary = summarise(f.definition, f.structure, f.motion);
  ASSERT_EQ(summary.change_points.size(), 2u);
  EXPECT_EQ(summary.change_points[0].at, 0.5);
  EXPECT_EQ(summary.change_points[0].joint, "cylinder");
  EXPECT_DOUBLE_EQ(summary.change_points[0].largest_force, 5.0);
  EXPECT_EQ(summary.change_points[1].joint, "");  // nothing holds the loads
  EXPECT_EQ(summary.instants_left_out, 1);
}

}  // namespace
}  // namespace clevis::report
