#include "mechanism/structure.h"

#include <gtest/gtest.h>

#include "mechanism/assur.h"
#include "support/four_bar.h"
#include "support/landing_gear.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

TEST(Structure, LandingGearInThePlaneAndInSpace) {
  const Structure s = analyse_structure(landing_gear());
  EXPECT_TRUE(s.planar);
  EXPECT_EQ(s.moving_links, 5);
  EXPECT_EQ(s.pairs, 7);
  EXPECT_EQ(s.chebyshev, 1);
  EXPECT_EQ(s.mobility, 1);
  EXPECT_EQ(s.redundant, 0);
  EXPECT_TRUE(s.redundant_in.empty());
  EXPECT_EQ(s.spatial_chebyshev, -5);
  EXPECT_EQ(s.spatial_mobility, 1);
  EXPECT_EQ(s.spatial_redundant, 6);
  EXPECT_EQ(s.spatial_redundant_in.size(), 7u);  // the weld is not one of them
}

TEST(Structure, LandingGearIsOfClassTwoWhateverTheInput) {
  MechanismDefinition m = landing_gear();
  Structure s = analyse_structure(m);
  EXPECT_EQ(s.assur_corrected,
            "I(cylinder) -> II(DCE,FE1+FE2) -> II(AB,BC+wheel)");
  EXPECT_EQ(s.assur_class_corrected, 2);
  EXPECT_EQ(s.assur_published, "I(FE1) -> III(AB,BC+wheel,DCE,FE2)");
  EXPECT_EQ(s.assur_class_published, 3);
  const std::pair<int, const char*> others[] = {
      {kF, "I(F) -> II(DCE,FE2) -> II(AB,BC+wheel)"},
      {kA, "I(A) -> II(BC+wheel,DCE) -> II(FE1,FE2)"},
      {kD, "I(D) -> II(AB,BC+wheel) -> II(FE1,FE2)"}};
  for (const auto& [input, formula] : others) {
    m.drives[0].joint = input;
    s = analyse_structure(m);
    EXPECT_EQ(s.assur_corrected, formula);
    EXPECT_EQ(s.assur_class_corrected, 2);
  }
}

// AB and DC equal, AD and BC equal: at theta = 90 degrees all pins lie on one
// line and the four-bar ABCD has two instantaneous freedoms; the general
// mobility is still 1.
TEST(Structure, MobilityAtTheChangePointIsTheGeneralOne) {
  FourBar parallelogram{
      .ground = 0.06, .crank = 0.14, .coupler = 0.06, .rocker = 0.14};
  MechanismDefinition m = four_bar(parallelogram, 0.0);
  for (BodyDefinition& body : m.bodies) {  // all on the line of the ground
    body.placement.R_WL = Eigen::Matrix3d::Identity();
  }
  m.bodies[1].placement.p_WL = {0.14, 0.0, 0.0};
  m.bodies[2].placement.p_WL = {0.06, 0.0, 0.0};
  const Structure s = analyse_structure(m);
  EXPECT_EQ(s.mobility, 1);
  EXPECT_EQ(s.redundant, 0);
}

TEST(Structure, FourBarIsOneDyad) {
  const Structure s = analyse_structure(four_bar({}, 1.0));
  EXPECT_EQ(s.chebyshev, 1);
  EXPECT_EQ(s.mobility, 1);
  EXPECT_EQ(s.spatial_redundant, 3);
  EXPECT_EQ(s.assur_corrected, "I(O) -> II(coupler,rocker)");
}

/// Crank at ground, ternary link, and three leads: two at ground, one at the
/// crank's end. No dyad can be split off.
TEST(Assur, TriadIsOfClassThree) {
  LinkGraph graph{.links = {"base link", "lead 1", "lead 2", "lead 3"},
                  .pairs = {{0, 1, 0},
                            {0, 2, 1},
                            {0, 3, 2},
                            {1, kGround, 3},
                            {2, kGround, 4},
                            {3, kGround, 5}}};
  const auto groups = peel_groups(graph);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].group_class, 3);
  EXPECT_EQ(groups[0].order, 3);
}

TEST(Assur, QuadrilateralLoopIsOfClassFour) {
  // ternary links 0 and 2 in a loop with binary 1 and 3, each at ground
  LinkGraph graph{.links = {"0", "1", "2", "3"},
                  .pairs = {{0, 1, 0},
                            {1, 2, 1},
                            {2, 3, 2},
                            {3, 0, 3},
                            {0, kGround, 4},
                            {2, kGround, 5}}};
  const auto groups = peel_groups(graph);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].group_class, 4);
  EXPECT_EQ(groups[0].order, 2);
}

TEST(Assur, WhatDoesNotSplitIsNoGroup) {
  // a chain with one freedom left
  LinkGraph graph{.links = {"crank", "rod"},
                  .pairs = {{0, kGround, 0}, {0, 1, 1}}};
  EXPECT_TRUE(peel_groups(graph).empty());
}

}  // namespace
}  // namespace clevis::mechanism
