// Change points that integrated motions pass.
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/errors.h"
#include "mechanism/rank_watch.h"
#include "mechanism/simulate.h"
#include "support/four_bar.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

/// Of the two windows from upright at 1 rad/s: 3/2 w² + 7/2 g sin is constant.
double speed(double angle) {
  return std::sqrt(1.0 + 7.0 / 3.0 * 9.81 * (1.0 - std::sin(angle)));
}

/// Time from upright to `angle` below it, by Simpson's rule.
double time_to(double angle) {
  constexpr int n = 20000;
  const double up = 0.5 * std::numbers::pi, h = (angle - up) / n;
  double sum = 1.0 / speed(up) + 1.0 / speed(angle);
  for (int i = 1; i < n; ++i) {
    sum += (i % 2 == 1 ? 4.0 : 2.0) / speed(up + i * h);
  }
  return std::abs(sum * h / 3.0);
}

TEST(DynamicChangePoint, AllTenAreFoundWhateverTheStepsAndInstants) {
  for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-10}) {
    const Motion motion =
        simulate(two_window_four_bar(),
                 {.duration = 10.0, .instants = 7, .tolerance = tolerance});
    ASSERT_EQ(motion.change_points.size(), 10u) << tolerance;
    for (int i = 0; i < 10; ++i) {
      const ChangePoint& point =
          motion.change_points[static_cast<std::size_t>(i)];
      const double t = time_to(-i * std::numbers::pi);
      EXPECT_NEAR(point.t, t, 2.0 * tolerance + 1e-8) << i;
      EXPECT_LE(point.t_before, t);
      EXPECT_GE(point.t_after, t);
      EXPECT_FALSE(point.at.has_value());
    }
  }
}

TEST(DynamicChangePoint, StopRefusesTheFirst) {
  try {
    simulate(two_window_four_bar(),
             {.duration = 10.0, .at_singularity = AtSingularity::kStop});
    FAIL() << "passed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "K005");
    EXPECT_NE(error.problem().find("t = 0.7143555"), std::string::npos)
        << error.problem();
  }
}

// At 0° the two windows turn by −7/6 g: the branch's acceleration, where J
// leaves two more freedoms.
TEST(DynamicChangePoint, AnInstantJustThereIsOfTheBranchAndFlagged) {
  const Motion motion = simulate(
      two_window_four_bar(), {.duration = 2.0 * time_to(0.0), .instants = 3});
  ASSERT_EQ(motion.instants.size(), 3u);
  EXPECT_FALSE(motion.instants[0].is_change_point);
  EXPECT_TRUE(motion.instants[1].is_change_point);
  EXPECT_FALSE(motion.instants[2].is_change_point);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(motion.instants[1].bodies[i].alpha_WL.z(), -3.5 / 3.0 * 9.81,
                1e-5);
  }
}

/// A parallelogram of 2 m by 1 m without weight that coasts through the line
/// of its pins at 1 rad/s.
MechanismDefinition coasting() {
  MechanismDefinition m = four_bar(
      {.ground = 2.0, .crank = 1.0, .coupler = 2.0, .rocker = 1.0}, 0.5);
  m.gravity_W.setZero();
  m.bodies[0].placement.R_WL = m.bodies[2].placement.R_WL = turned(0.5);
  m.bodies[1].placement.R_WL.setIdentity();
  m.bodies[1].placement.p_WL = m.bodies[0].placement.R_WL.col(0);
  m.drives.clear();
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = -1.0, .place = "initial"}};
  return m;
}

// All in line, pins equally compliant: the coupler's centripetal 4 N (4 kg in
// 1 m) are shared by both ends, crank and rocker (2 kg in 0.5 m) add 1 N each.
TEST(DynamicChangePoint, CompliantForcesInLine) {
  MechanismDefinition m = coasting();
  for (JointDefinition& joint : m.joints) {
    joint.compliance = {Vector3d::Constant(1e-8), Vector3d::Constant(1e-8)};
  }
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 12});
  ASSERT_EQ(motion.change_points.size(), 1u);
  EXPECT_NEAR(motion.change_points[0].t, 0.5, 1e-8);
  ASSERT_TRUE(motion.change_points[0].at);
  const Instant& at = *motion.change_points[0].at;
  const double forces[] = {3.0, 2.0, 2.0, 3.0};
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_NEAR(at.joints[j].f_W.norm(), forces[j], 1e-5) << j;
  }
  // at constant speed, on the branch
  EXPECT_LT(at.bodies[0].alpha_WL.norm(), 1e-7);
  EXPECT_LT(at.bodies[1].alpha_WL.norm(), 1e-7);
  EXPECT_NEAR(at.bodies[1].a_WLo.x(), -1.0, 1e-6);
}

// Coupler and rocker stretched: the crank's end is 2.2 m from the rocker's pin.
TEST(DynamicChangePoint, DriveMeetsADeadEnd) {
  constexpr double kFrom = 1.0, kTo = 2.0;
  MechanismDefinition m = four_bar(
      {.ground = 2.0, .crank = 1.5, .coupler = 1.0, .rocker = 1.2}, kFrom);
  m.bodies.push_back(
      testing::uniform_bar("pendulum", m.bodies[2].placement.p_WL, -1.0, 0.3));
  m.joints.push_back(testing::pin("P", 2, 3, 0.0, 0.0));
  for (const DriveLaw law : {DriveLaw::kRamp, DriveLaw::kQuintic}) {
    m.drives[0].law = law;
    m.drives[0].from = kFrom;
    m.drives[0].to = kTo;
    m.drives[0].duration = 1.0;
    try {
      simulate(m, {.duration = 1.0});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "K004");
      const double end = std::acos((2.25 + 4.0 - 4.84) / 6.0);
      EXPECT_NE(
          std::string(error.what())
              .find(fmt::format(" at {:.4f}", end * 180.0 / std::numbers::pi)),
          std::string::npos)
          << error.what();
    }
  }
}

TEST(DynamicChangePoint, CloseIsNotThere) {
  MechanismDefinition m = four_bar(
      {.ground = 1.001, .crank = 1.0, .coupler = 1.001, .rocker = 1.001}, 0.5);
  m.drives.clear();
  m.gravity_W.setZero();
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 6.0, .place = "initial"}};
  EXPECT_TRUE(simulate(m, {.duration = 3.0}).change_points.empty());
}

TEST(DynamicChangePoint, IsFoundAmongRedundantConstraints) {
  MechanismDefinition m = coasting();
  m.dimension = SpaceDimension::kSpatial;
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 4});
  ASSERT_EQ(motion.change_points.size(), 1u);
  EXPECT_NEAR(motion.change_points[0].t, 0.5, 1e-8);
}

// Rows cos t, sin t and a fixed one: dependent where cos t = 0; by steps of
// half a turn and more.
TEST(RankWatch, FindsZerosOfLongSteps) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    J << std::cos(t), std::sin(t), 0.0, 1.0;
  };
  for (const double step : {0.1, 1.0, 2.0, 3.0}) {
    RankWatch watch(2, 2, 2);
    EXPECT_FALSE(watch.start(jacobian, 0.0));
    std::vector<double> found;
    for (double t = step; t < 30.0; t += step) {
      for (const double zero : watch.look(jacobian, t)) found.push_back(zero);
    }
    ASSERT_GE(found.size(), 8u) << step;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], (static_cast<double>(i) + 0.5) * std::numbers::pi,
                  1e-12);
    }
  }
}

// There and back within one step: the directions end as they began.
TEST(RankWatch, FindsAShortExcursion) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    J << 1.0, 1.01 - std::sin(t) * 1.02, 1.0, 0.0;
  };
  RankWatch watch(2, 2, 2);
  EXPECT_FALSE(watch.start(jacobian, 0.0));
  EXPECT_EQ(watch.look(jacobian, 3.0).size(), 2u);
}

TEST(RankWatch, SaysIfItStartsThere) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    J << 1.0, t, 1.0, 0.0;
  };
  RankWatch watch(2, 2, 2);
  EXPECT_TRUE(watch.start(jacobian, 0.0));
  EXPECT_TRUE(watch.look(jacobian, 1.0).empty());
}

}  // namespace
}  // namespace clevis::mechanism
