#include "mechanism/structure/structure.h"

#include <gtest/gtest.h>

#include "mechanism/structure/assur.h"
#include "support/four_bar.h"
#include "support/free_linkages.h"
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

// As published the gear is of class III; taken apart without a drive it is of
// class II like with one, led by the first joint on ground.
TEST(Structure, LandingGearWithoutDriveIsLedFromGround) {
  MechanismDefinition m = landing_gear();
  m.drives.clear();
  const Structure s = analyse_structure(m);
  EXPECT_EQ(s.assur_corrected, "I(A) -> II(BC+wheel,DCE) -> II(FE1,FE2)");
  EXPECT_EQ(s.assur_class_corrected, 2);
  EXPECT_EQ(s.assur_inputs, std::vector<std::string>{"A"});
  EXPECT_EQ(s.assur_published, "");
}

TEST(Structure, ActuatedJointsLeadBeforeThoseOnGround) {
  MechanismDefinition m = landing_gear();
  m.drives.clear();
  LineElement force;
  force.name = "push";
  force.line.joint = kD;
  force.law = TableLaw{.times = {0.0}, .efforts = {1.0}};
  m.elements.push_back(force);
  EXPECT_EQ(analyse_structure(m).assur_corrected,
            "I(D) -> II(AB,BC+wheel) -> II(FE1,FE2)");
  force.line.joint = kCylinder;
  force.law = MotorLaw{};
  m.elements.push_back(force);  // acts, where the other only pushes
  EXPECT_EQ(analyse_structure(m).assur_corrected,
            "I(cylinder) -> II(DCE,FE1+FE2) -> II(AB,BC+wheel)");
}

TEST(Structure, TwoWindowFourBarIsTwoDyads) {
  const Structure s = analyse_structure(two_window_four_bar());
  EXPECT_EQ(s.mobility, 1);
  EXPECT_EQ(s.assur_class_corrected, 2);
  EXPECT_EQ(s.assur_inputs.size(), 1u);
  EXPECT_EQ(s.assur_corrected,
            "I(A0) -> II(upright_1,level_0) -> II(upright_2,level_1)");
}

/// A body on a slide, a hinge on it; a free body.
MechanismDefinition slide_with_pendulum() {
  MechanismDefinition m;
  for (const char* name : {"mass", "pendulum"}) {
    BodyDefinition body;
    body.name = name;
    body.mass_properties = bar(1.0, 0.0, 0.0, 1e-3);
    m.bodies.push_back(body);
  }
  m.joints.push_back({.name = "slide",
                      .type = JointType::kPrismatic,
                      .body_b = 0,
                      .frame_a = slide(1.0),
                      .frame_b = slide(1.0),
                      .place = {}});
  m.joints.push_back({.name = "hinge",
                      .type = JointType::kRevolute,
                      .body_a = 0,
                      .body_b = 1,
                      .frame_a = at(0.0, 0.0),
                      .frame_b = at(0.0, 0.0),
                      .place = {}});
  m.dimension = SpaceDimension::kPlanar;
  return m;
}

// What hangs on no loop is led joint by joint, without any group.
TEST(Structure, OpenChainsHaveNoGroups) {
  MechanismDefinition m = slide_with_pendulum();
  Structure s = analyse_structure(m);
  EXPECT_EQ(s.assur_corrected, "I(slide,hinge)");
  EXPECT_EQ(s.assur_class_corrected, 1);
  EXPECT_EQ(s.assur_inputs, (std::vector<std::string>{"slide", "hinge"}));
  DriveDefinition drive;
  drive.joint = 0;
  m.drives.push_back(drive);
  s = analyse_structure(m);
  EXPECT_EQ(s.assur_corrected, "I(slide,hinge)");
  EXPECT_EQ(s.assur_inputs, std::vector<std::string>{"hinge"});
  m.drives.clear();
  m.joints.pop_back();
  m.bodies.pop_back();
  EXPECT_EQ(analyse_structure(m).assur_corrected, "I(slide)");
}

TEST(Structure, SaysWhyThereAreNoGroups) {
  MechanismDefinition m = slide_with_pendulum();
  m.joints.pop_back();
  EXPECT_EQ(analyse_structure(m).assur_none, "no joint leads pendulum");
  m = slide_with_pendulum();
  m.joints[1].type = JointType::kDistance;
  m.joints[1].length = 0.1;
  m.bodies[1].placement.p_WL = {0.1, 0.0, 0.0};
  EXPECT_EQ(analyse_structure(m).assur_none, "hinge: neither hinge nor slide");
  m = slide_with_pendulum();
  m.joints.push_back(m.joints[0]);
  m.joints[2].name = "slide again";
  EXPECT_EQ(analyse_structure(m).assur_none,
            "redundant constraints among slide, slide again");
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

// Sixty dyads in a row, closed from the far end: a search through all choices
// of links would not end.
TEST(Assur, LongRowsOfDyadsSplit) {
  constexpr int n = 60;
  LinkGraph graph;
  for (int i = 0; i < 2 * n; ++i) {
    graph.links.push_back(std::to_string(i));
    const int carrier = i % 2 == 1 ? kGround : i + 2 < 2 * n ? i + 2 : kGround;
    graph.pairs.push_back({i, carrier, 2 * i});
    if (i % 2 == 0) graph.pairs.push_back({i, i + 1, 2 * i + 1});
  }
  const auto groups = peel_groups(graph);
  ASSERT_EQ(groups.size(), static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const int first = 2 * (n - 1 - i);
    EXPECT_EQ(groups[static_cast<std::size_t>(i)].links,
              (std::vector<int>{first, first + 1}));
    EXPECT_EQ(groups[static_cast<std::size_t>(i)].group_class, 2);
  }
}

// Two links on ground fixed by three pairs among them, and a third with too
// few: the sum is right, yet no part of it is determined.
TEST(Assur, AnExcessDoesNotMakeUpForALack) {
  LinkGraph graph{.links = {"a", "b", "c", "d"},
                  .pairs = {{0, kGround, 0},
                            {0, kGround, 1},
                            {1, kGround, 2},
                            {2, 1, 3},
                            {3, 2, 4},
                            {3, kGround, 5}}};
  EXPECT_TRUE(peel_groups(graph).empty());
}

TEST(Assur, WhatDoesNotSplitIsNoGroup) {
  // a chain with one freedom left
  LinkGraph graph{.links = {"crank", "rod"},
                  .pairs = {{0, kGround, 0}, {0, 1, 1}}};
  EXPECT_TRUE(peel_groups(graph).empty());
}

}  // namespace
}  // namespace clevis::mechanism
