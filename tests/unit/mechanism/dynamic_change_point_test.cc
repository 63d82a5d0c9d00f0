// Change points that integrated motions pass.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
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

/// Windows of equal cranks without weight, coasting or turned by a moment.
struct Parallelograms {
  double crank{}, base{}, angle{}, rate{};
  double acceleration{};  ///< [rad/s²]
  double tolerance{};
  int windows = 1;
  bool spatial = false;
};

MechanismDefinition linkage(const Parallelograms& p) {
  MechanismDefinition m;
  if (p.spatial) m.dimension = SpaceDimension::kSpatial;
  const Vector3d arm =
      p.crank * Vector3d(std::cos(p.angle), std::sin(p.angle), 0.0);
  const int n = p.windows;
  double inertia = 0.0;  // of the cranks, then of what they carry around
  for (int k = 0; k <= n; ++k) {
    const Vector3d foot(k * p.base, 0.0, 0.0);
    m.bodies.push_back(testing::uniform_bar("crank", foot, p.angle, p.crank));
    inertia += p.crank * p.crank / 3.0;
  }
  for (int k = 0; k < n; ++k) {
    m.bodies.push_back(testing::uniform_bar(
        "bar", Vector3d(k * p.base, 0.0, 0.0) + arm, 0.0, p.base));
    inertia += p.crank * p.crank;
  }
  for (int k = 0; k <= n; ++k) {
    m.joints.push_back(testing::pin("A", kGround, k, k * p.base, 0.0));
  }
  for (int k = 0; k < n; ++k) {
    m.joints.push_back(testing::pin("B", k, n + 1 + k, p.crank, 0.0));
    m.joints.push_back(testing::pin("C", n + 1 + k, k + 1, p.base, p.crank));
  }
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = p.rate, .place = "initial"}};
  if (p.acceleration != 0.0) {
    ConstantForce couple;
    couple.point.body = 0;
    couple.t_W = {0.0, 0.0, p.acceleration * inertia};
    m.elements = {couple};
  }
  return m;
}

/// When the cranks stand in the line of their feet.
std::vector<double> passes(const Parallelograms& p, double duration) {
  std::vector<double> times;
  for (int k = -100; k <= 100; ++k) {
    const double way = k * std::numbers::pi - p.angle;
    if (p.acceleration == 0.0) {
      times.push_back(way / p.rate);
      continue;
    }
    const double square = p.rate * p.rate + 2.0 * p.acceleration * way;
    if (square < 0.0) continue;
    times.push_back((-p.rate + std::sqrt(square)) / p.acceleration);
    times.push_back((-p.rate - std::sqrt(square)) / p.acceleration);
  }
  std::erase_if(times, [&](double t) {
    return t <= 0.0 || t >= duration;
  });
  std::ranges::sort(times);
  return times;
}

void expect_every_pass(const Parallelograms& p) {
  constexpr double kDuration = 2.0;
  const Motion motion = simulate(
      linkage(p),
      {.duration = kDuration, .instants = 5, .tolerance = p.tolerance});
  const std::vector<double> times = passes(p, kDuration);
  ASSERT_EQ(motion.change_points.size(), times.size())
      << p.angle << " " << p.rate << " " << p.tolerance;
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(motion.change_points[i].t, times[i], p.tolerance) << p.rate;
  }
}

// Scenes whose steps end beside a change point, or whose dense output is wrong
// there by a hundred times the tolerance.
TEST(DynamicChangePoint, EveryPassOfParallelogramsIsListedOnce) {
  constexpr double kHalf = 0.5 * std::numbers::pi;
  const Parallelograms all[] = {
      {1.0, 1.0, kHalf, 1.0, 0.0, 1e-4},
      {1.0, 1.0, kHalf, 1.0, 0.0, 1e-5},
      {1.0, 1.0, kHalf, -6.0, 0.0, 1e-3},
      {1.0, 1.0, -2.2176532294535525, -8.80915707810213, -12.912, 1e-6},
      {1.0, 2.0, 2.0629086705056174, -9.783022929616289, 0.0, 1e-4},
      {0.5, 0.3, -1.526038907910043, 22.400739604064146, 0.0, 1e-5},
      {1.0, 2.0, -2.7488297678127735, 36.95012644959753, 0.0, 1e-3},
      {1.0, 1.0, 2.356266551823995, 17.416657982485912, -31.35577047481337,
       1e-5},
      {0.1, 1.0, 0.8975818400312701, -1.46367392057364, 0.0, 1e-6, 1, true},
      {0.5, 1.0, -0.8795826164541545, 29.085179240900217, 0.0, 1e-4, 1, true},
      {1.0, 0.3, -2.28587665755735, -30.721931137255936, 0.0, 1e-6, 2},
      {1.0, 0.3, -2.4529303522384964, -6.461707069488, 0.0, 1e-6, 2},
      {0.5, 1.0, -1.2538642981171502, 27.731716430521757, -30.995172037481822,
       1e-4, 2},
      {0.5, 0.3, -0.13838580144457868, -11.37873945289035, 0.0, 1e-5, 2, true},
  };
  for (const Parallelograms& p : all) expect_every_pass(p);
  std::mt19937 random(4);
  const auto draw = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967295.0;
  };
  for (int k = 0; k < 24; ++k) {
    expect_every_pass({.crank = draw(0.3, 1.0),
                       .base = draw(0.3, 2.0),
                       .angle = draw(-3.0, 3.0),
                       .rate = std::pow(10.0, draw(0.0, 1.6)),
                       .acceleration = k % 2 == 0 ? 0.0 : draw(-40.0, 40.0),
                       .tolerance = std::pow(10.0, -3 - k % 4),
                       .spatial = k % 3 == 0});
  }
}

}  // namespace
}  // namespace clevis::mechanism
