// Reactions that equilibrium leaves open, as joints of other compliance share
// them: springs side by side in closed form, corners against a motion that is
// simulated anew, random compliances between the corners.
#include "mechanism/reactions/other_sharings.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mechanism/reactions/largest_reaction.h"
#include "mechanism/simulate.h"
#include "support/bennett.h"
#include "support/newton_euler.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

const SimulationSettings kSettings{.duration = 1.0, .instants = 5};
constexpr double kForce = 9000.0, kApart = 0.1;

/// A link on two hinges to the ground, pulled along it.
MechanismDefinition link_on_two_hinges() {
  MechanismDefinition m;
  BodyDefinition body;
  body.name = "link";
  body.place = "body link";
  body.mass_properties = bar(0.1, 0.5 * kApart, 0.0, 0.1);
  m.bodies = {body};
  for (const double x : {0.0, kApart}) {
    JointDefinition hinge;
    hinge.name = x == 0.0 ? "A" : "B";
    hinge.type = JointType::kRevolute;
    hinge.body_b = 0;
    hinge.frame_a.p_LJ = hinge.frame_b.p_LJ = {x, 0.0, 0.0};
    m.joints.push_back(hinge);
  }
  ConstantForce pull;
  pull.name = "pull";
  pull.point.body = 0;
  pull.f_W = {kForce, 0.0, 0.0};
  m.elements = {pull};
  return m;
}

double pull_of(const Motion& motion, std::size_t joint) {
  return motion.instants[0].joints[joint].f_W.x();
}

// Compliances a and b side by side: B carries a / (a + b).
TEST(OtherSharings, TwoHingesBetweenSoftAndStiff) {
  const MechanismDefinition m = link_on_two_hinges();
  const Motion motion = simulate(m, kSettings);
  EXPECT_NEAR(pull_of(motion, 0), -0.5 * kForce, 1e-9 * kForce);
  const OtherSharings sharings(m, motion);
  EXPECT_TRUE(sharings.is_complete());
  EXPECT_EQ(sharings.unknown(), (std::vector<std::string>{"A", "B"}));
  ASSERT_EQ(sharings.size(), 2u);  // both soft, both stiff: as before
  std::vector<double> at_A;
  for (std::size_t i = 0; i < 2; ++i) {
    const Motion other = sharings.motion(i);
    at_A.push_back(-pull_of(other, 0) / kForce);
    EXPECT_NEAR(pull_of(other, 0) + pull_of(other, 1), -kForce, 1e-9 * kForce);
  }
  std::ranges::sort(at_A);
  EXPECT_NEAR(at_A[0], 0.01 / (0.01 + 100.0), 1e-9);
  EXPECT_NEAR(at_A[1], 100.0 / (0.01 + 100.0), 1e-9);
}

TEST(OtherSharings, GivenCompliancesAreKnownToHalfAndTwice) {
  MechanismDefinition m = link_on_two_hinges();
  m.joints[0].compliance =
      JointCompliance{Vector3d::Constant(2e-9), Vector3d::Constant(1e-6)};
  m.joints[1].compliance =
      JointCompliance{Vector3d::Constant(6e-9), Vector3d::Constant(1e-6)};
  const Motion motion = simulate(m, kSettings);
  EXPECT_NEAR(pull_of(motion, 0), -0.75 * kForce, 1e-9 * kForce);
  const OtherSharings sharings(m, motion);
  EXPECT_TRUE(sharings.unknown().empty());
  std::vector<double> at_A;
  for (std::size_t i = 0; i < sharings.size(); ++i) {
    at_A.push_back(-pull_of(sharings.motion(i), 0) / kForce);
  }
  ASSERT_EQ(at_A.size(), 2u);
  EXPECT_NEAR(*std::ranges::min_element(at_A), 3.0 / (4.0 + 3.0), 1e-9);
  EXPECT_NEAR(*std::ranges::max_element(at_A), 12.0 / (1.0 + 12.0), 1e-9);
}

/// A slider-like loop in space with everything open: Bennett's.
MechanismDefinition loop() {
  return bennett({}, 1.2);
}

// The corner's reactions are those of a motion simulated with its compliances.
TEST(OtherSharings, AreThoseOfAMotionWithThatCompliance) {
  MechanismDefinition m = link_on_two_hinges();
  m.gravity_W = {3.0, -9.81, 1.0};
  m.bodies[0].mass_properties.p_LCm.z() = 0.02;
  const Motion motion = simulate(m, kSettings);
  const OtherSharings sharings(m, motion);
  ASSERT_GT(sharings.size(), 2u);
  const double turn = 1e-9;  // compliance of moments: factors count only
  int found = 0;
  for (std::size_t i = 0; i < sharings.size(); ++i) {
    const Motion other = sharings.motion(i);
    for (int bits = 0; bits < 16; ++bits) {
      MechanismDefinition changed = m;
      const auto factor = [bits](int k) {
        return (bits >> k & 1) != 0 ? 100.0 : 0.01;
      };
      // ℓ of the link: half of the distance of its hinges
      const double length = 0.5 * kApart;
      for (int j = 0; j < 2; ++j) {
        changed.joints[static_cast<std::size_t>(j)].compliance =
            JointCompliance{Vector3d::Constant(1e-9 * factor(2 * j)),
                            Vector3d::Constant(turn / (length * length) *
                                               factor(2 * j + 1))};
      }
      const Motion again = simulate(changed, kSettings);
      double apart = 0.0;
      for (std::size_t j = 0; j < 2; ++j) {
        apart = std::max(apart, (again.instants[2].joints[j].components() -
                                 other.instants[2].joints[j].components())
                                    .norm());
      }
      if (apart < 1e-6) ++found;
    }
  }
  EXPECT_EQ(found, static_cast<int>(sharings.size()));
}

// Any convex measure: with compliances drawn from the box none of a joint's
// components leaves the range of the corners.
TEST(OtherSharings, CornersBoundWhatLiesBetween) {
  MechanismDefinition m = link_on_two_hinges();
  m.gravity_W = {3.0, -9.81, 1.0};
  m.bodies[0].mass_properties.p_LCm.z() = 0.02;
  const Motion motion = simulate(m, kSettings);
  const OtherSharings sharings(m, motion);
  ASSERT_TRUE(sharings.is_complete());
  using Components = Eigen::Matrix<double, 12, 1>;
  const auto components = [](const Motion& of) {
    Components c;
    c << of.instants[0].joints[0].components(),
        of.instants[0].joints[1].components();
    return c;
  };
  Components low = components(motion), high = low;
  for (std::size_t i = 0; i < sharings.size(); ++i) {
    const Components c = components(sharings.motion(i));
    low = low.cwiseMin(c);
    high = high.cwiseMax(c);
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-2.0, 2.0);
  const double length = 0.5 * kApart;
  for (int trial = 0; trial < 200; ++trial) {
    MechanismDefinition drawn = m;
    for (JointDefinition& joint : drawn.joints) {
      joint.compliance = JointCompliance{
          Vector3d::Constant(1e-9 * std::pow(10.0, exponent(random))),
          Vector3d::Constant(1e-9 / (length * length) *
                             std::pow(10.0, exponent(random)))};
    }
    const Components c = components(simulate(drawn, kSettings));
    EXPECT_LT((low - c).maxCoeff(), 1e-6);
    EXPECT_LT((c - high).maxCoeff(), 1e-6);
  }
}

// A beam on eight feet, too many for all corners: the outer two carry it, or a
// foot and its neighbour, where the others give way.
TEST(OtherSharings, AnyTwoOfEightFeetMayCarryABeam) {
  constexpr int kFeet = 8;
  constexpr double kLoad = 3000.0;
  MechanismDefinition m = link_on_two_hinges();
  m.joints.clear();
  for (int i = 0; i < kFeet; ++i) {
    JointDefinition foot;
    foot.name = std::string(1, static_cast<char>('A' + i));
    foot.type = JointType::kRevolute;
    foot.body_b = 0;
    foot.frame_a.p_LJ = foot.frame_b.p_LJ = {kApart * i, 0.0, 0.0};
    m.joints.push_back(foot);
  }
  ConstantForce press;
  press.name = "press";
  press.point.body = 0;
  press.point.p_L = {0.5 * kApart * (kFeet - 1), 0.0, 0.0};
  press.f_W = {0.0, -kLoad, 0.0};
  m.elements = {press};
  const Motion motion = simulate(m, kSettings);
  const OtherSharings sharings(m, motion);
  EXPECT_FALSE(sharings.is_complete());
  double outer = 0.0;
  for (std::size_t i = 0; i < sharings.size(); ++i) {
    outer =
        std::max(outer, sharings.motion(i).instants[0].joints[0].f_W.norm());
  }
  EXPECT_GT(outer, 0.49 * kLoad);
}

TEST(OtherSharings, BalanceHoldsInEach) {
  const MechanismDefinition m = loop();
  const Motion motion = simulate(m, kSettings);
  const OtherSharings sharings(m, motion);
  EXPECT_FALSE(sharings.is_complete());  // forces and moments of four hinges
  ASSERT_GT(sharings.size(), 8u);
  for (std::size_t i = 0; i < sharings.size(); ++i) {
    const Motion other = sharings.motion(i);
    for (const Instant& at : other.instants) {
      EXPECT_LT(imbalance(m, at), 1e-9);
    }
  }
}

TEST(OtherSharings, DeterminateMechanismHasNone) {
  MechanismDefinition m = link_on_two_hinges();
  m.joints.pop_back();
  m.drives.resize(1);
  m.drives[0].law = DriveLaw::kConstant;
  const Motion motion = simulate(m, kSettings);
  EXPECT_EQ(OtherSharings(m, motion).size(), 0u);
}

// Across the plane the hinges of a planar mechanism are redundant. A centre of
// mass 1e-6 mm off it opens nothing that counts; one 10 mm off does.
TEST(OtherSharings, AHairOffThePlaneDecidesNothing) {
  for (const double off : {1e-9, 1e-2}) {
    MechanismDefinition m = link_on_two_hinges();
    m.elements.clear();
    m.gravity_W = {0.0, -9.81, 0.0};
    m.joints[0].compliance =
        JointCompliance{Vector3d::Constant(1e-9), Vector3d::Constant(1e-6)};
    m.bodies[0].mass_properties.p_LCm.z() = off;
    const Motion motion = simulate(m, kSettings);
    const bool is_open = off > 1e-6;
    for (const JointReaction& joint : motion.instants[0].joints) {
      EXPECT_EQ(joint.unique, !is_open);
    }
    EXPECT_EQ(OtherSharings(m, motion).size() > 0, is_open);
  }
}

TEST(LargestReaction, BesideAJointIsThatOfItsBodyLoadedLeast) {
  Motion motion;
  Instant& instant = motion.instants.emplace_back();
  std::vector<JointDefinition> joints;
  const auto add = [&](BodyIndex a, BodyIndex b, double force) {
    JointDefinition& joint = joints.emplace_back();
    joint.body_a = a;
    joint.body_b = b;
    instant.joints.emplace_back().f_W = {force, 0.0, 0.0};
  };
  add(kGround, 0, 100.0);
  add(0, 1, 2.0);
  add(1, kGround, 0.1);
  add(kGround, 2, 1e-9);  // round-off of the first
  instant.joints[2].t_W = {0.0, 0.0, 1.5};
  const auto beside = reactions_beside(joints, motion, 0.5);
  ASSERT_EQ(beside.size(), 4u);
  EXPECT_DOUBLE_EQ(beside[0], 100.0);
  EXPECT_DOUBLE_EQ(beside[1], 3.0);
  EXPECT_DOUBLE_EQ(beside[2], 3.0);
  EXPECT_DOUBLE_EQ(beside[3], 1e-4);
}

// A link is open whatever a press beside it, on the same ground, bears.
TEST(OtherSharings, WhatOtherBodiesBearMakesNothingNegligible) {
  MechanismDefinition m = link_on_two_hinges();
  BodyDefinition press = m.bodies[0];
  press.name = "press";
  m.bodies.push_back(press);
  JointDefinition foot;
  foot.name = "foot";
  foot.type = JointType::kWeld;
  foot.body_b = 1;
  m.joints.push_back(foot);
  ConstantForce load;
  load.name = "load";
  load.point.body = 1;
  load.f_W = {0.0, -1e7 * kForce, 0.0};
  m.elements.emplace_back(load);
  const Motion motion = simulate(m, kSettings);
  EXPECT_FALSE(motion.instants[0].joints[0].unique);
  EXPECT_TRUE(motion.instants[0].joints[2].unique);
  EXPECT_EQ(OtherSharings(m, motion).size(), 2u);
}

}  // namespace
}  // namespace clevis::mechanism
