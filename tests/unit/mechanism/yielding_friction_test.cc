// Joints at rest of which one has to yield as a drive sets in: that which
// reaches its breakaway first.
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::on_joint;

FrictionLaw coulomb(double effort) {
  return {.breakaway = effort, .kinetic = effort};
}

DriveDefinition quintic(double start, double to, double duration) {
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kQuintic;
  drive.to = to;
  drive.start = start;
  drive.duration = duration;
  return drive;
}

/// A block of 1 kg on a table that a drive moves by 0.1 m, with friction
/// between both, and between block and ground.
MechanismDefinition sledge(double table, double rail, double start) {
  MechanismDefinition m = testing::sliders({2.0, 1.0});
  LineElement sole;
  sole.name = "sole";
  sole.line.kind = ElementLine::Kind::kSlide;
  sole.line.a.body = 0;
  sole.line.b.body = 1;
  sole.law = coulomb(table);
  m.elements = {sole, on_joint(1, coulomb(rail))};
  m.drives = {quintic(start, 0.1, 1.0)};
  return m;
}

SimulationSettings settings(double tolerance) {
  return {.duration = 2.0, .instants = 21, .tolerance = tolerance};
}

TEST(YieldingFriction, BlockStaysWithTheStrongerOfTwo) {
  for (const double start : {0.0, 0.3}) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const Motion stays =
          simulate(sledge(2.0, 5.0, start), settings(tolerance));
      const Motion rides =
          simulate(sledge(5.0, 2.0, start), settings(tolerance));
      for (std::size_t i = 0; i < stays.instants.size(); ++i) {
        const double table = rides.instants[i].bodies[0].pose.p_WL.x();
        EXPECT_NEAR(stays.instants[i].bodies[1].pose.p_WL.x(), 0.0, tolerance);
        EXPECT_NEAR(rides.instants[i].bodies[1].pose.p_WL.x(), table,
                    tolerance);
      }
      // half way: the table slides, at its most; the drive pays for both
      const double t = start + 0.5;
      const auto at = static_cast<std::size_t>(std::lround(10.0 * t));
      EXPECT_NEAR(stays.instants[at].drives[0].effort, 2.0, 1e-6);
      EXPECT_NEAR(rides.instants[at].drives[0].effort, 2.0, 1e-6);
      EXPECT_NEAR(std::abs(stays.instants[at].elements[1].effort), 2.0, 1e-6);
    }
  }
}

// Two rails at 0.4 m guide one carriage: their rows depend on one another, in
// which friction along them has no part.
TEST(YieldingFriction, RedundantGuidesHoldNoMoreThanTheirFriction) {
  for (const auto dimension :
       {SpaceDimension::kPlanar, SpaceDimension::kSpatial}) {
    for (const double friction : {5.0, 60.0}) {
      MechanismDefinition m = testing::sliders({10.0});
      m.dimension = dimension;
      m.gravity_W = {9.81, 0.0, 0.0};
      m.joints.push_back(m.joints[0]);
      m.joints[1].name = "second";
      for (JointFrame* frame : {&m.joints[1].frame_a, &m.joints[1].frame_b}) {
        frame->p_LJ.y() += 0.4;
      }
      m.elements = {on_joint(0, coulomb(friction)),
                    on_joint(1, coulomb(friction))};
      const Motion motion =
          simulate(m, {.duration = 1.0, .instants = 3, .tolerance = 1e-8});
      const double a = std::max(0.0, 9.81 - 2.0 * friction / 10.0);
      EXPECT_NEAR(motion.instants.back().bodies[0].pose.p_WL.x(), 0.5 * a,
                  1e-7);
      const double holds = a > 0.0 ? friction : 0.5 * 98.1;
      EXPECT_NEAR(std::abs(motion.instants[0].elements[0].effort), holds, 1e-6);
    }
  }
}

/// Five bars of 1 kg, the first driven, friction in two joints: of the second
/// bar on the first, of the fifth on the ground.
MechanismDefinition five_bar(double strong, double weak) {
  const Vector3d pins[] = {{0.0, 0.0, 0.0},
                           {0.30, 0.36, 0.0},
                           {0.41, -0.24, 0.0},
                           {0.63, 0.245, 0.0},
                           {0.35, 0.0, 0.0}};
  MechanismDefinition m;
  const auto add = [&](int from, int to) {
    const Vector3d way = pins[to] - pins[from];
    m.bodies.push_back(testing::uniform_bar(
        "bar", pins[from], std::atan2(way.y(), way.x()), way.norm()));
    return way.norm();
  };
  const double first = add(0, 1), second = add(1, 2), third = add(3, 2);
  const double fourth = add(4, 3);
  m.joints = {testing::pin("j0", kGround, 0, 0.0, 0.0),
              testing::pin("j1", 0, 1, first, 0.0),
              testing::pin("j2", 1, 2, second, third),
              testing::pin("j3", 3, 2, fourth, 0.0),
              testing::pin("j4", kGround, 3, pins[4].x(), 0.0)};
  m.gravity_W = {0.0, -9.81, 0.0};
  m.elements = {on_joint(1, coulomb(strong)), on_joint(4, coulomb(weak))};
  const double start = std::atan2(0.36, 0.30);
  m.drives = {quintic(0.0, start - 0.3, 0.5)};
  m.drives[0].from = start;
  return m;
}

// With 20 N m the second bar never turns on the first: the same as held there.
TEST(YieldingFriction, FiveBarMovesAsIfHeldWhereFrictionIsStrong) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const SimulationSettings s{
        .duration = 1.0, .instants = 41, .tolerance = tolerance};
    const MechanismDefinition rubbing = five_bar(20.0, 0.6);
    MechanismDefinition held = five_bar(20.0, 0.6);
    DriveDefinition hold;
    hold.joint = 1;
    hold.law = DriveLaw::kConstant;
    hold.from = std::atan2(-0.60, 0.11) - std::atan2(0.36, 0.30);
    held.drives.push_back(hold);
    held.elements.erase(held.elements.begin());
    const Motion a = simulate(rubbing, s), b = simulate(held, s);
    double strongest = 0.0;
    for (std::size_t i = 0; i < a.instants.size(); ++i) {
      const auto tip = [&](const Motion& motion) {
        return motion.instants[i].bodies[2].pose.p_WL;
      };
      EXPECT_LT((tip(a) - tip(b)).norm(), 3.0 * tolerance) << i;
      strongest = std::max(strongest, std::abs(b.instants[i].drives[1].effort));
    }
    EXPECT_LT(strongest, 20.0);
    EXPECT_GT(strongest, 1.0);
  }
}

}  // namespace
}  // namespace clevis::mechanism
