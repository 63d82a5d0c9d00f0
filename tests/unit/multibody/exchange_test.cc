#include "multibody/exchange.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clevis::multibody {
namespace {

Model model() {
  Model result;
  result.name = "a \"b\"";
  result.gravity = Eigen::Vector3d(1.0, 2.0, -1.0 / 3.0);
  Link link{.name = "arm", .mass = 0.1, .is_fixed = true};
  link.p_WL << 1.0, 2.0, 3.0;
  link.R_WL << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  link.p_LCm << 4.0, 5.0, 6.0;
  link.inertia_LCm << 1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 2.5;
  result.links = {link};
  Axis axis;
  axis.direction << 0.0, 0.6, 0.8;
  axis.upper = 0.1;
  axis.stop_stiffness = 2.0;
  axis.stop_damping = 3.0;
  axis.damping = 4.0;
  axis.friction = 5.0;
  axis.spring_stiffness = 6.0;
  axis.spring_reference = 7.0;
  result.joints = {{.name = "pin",
                    .type = "screw",
                    .parent = "",
                    .child = "arm",
                    .point = {7.0, 8.0, 9.0},
                    .axes = {axis},
                    .lead = -0.001}};
  result.told = {"one", "two"};
  return result;
}

TEST(Exchange, BringsAModelAsItIs) {
  const Model sent = model(), got = read_answer(answer(sent));
  EXPECT_EQ(got.name, sent.name);
  EXPECT_EQ(*got.gravity, *sent.gravity);
  EXPECT_EQ(got.told, sent.told);
  ASSERT_EQ(got.links.size(), 1U);
  EXPECT_EQ(got.links[0].name, "arm");
  EXPECT_EQ(got.links[0].mass, 0.1);
  EXPECT_EQ(got.links[0].p_WL, sent.links[0].p_WL);
  EXPECT_EQ(got.links[0].R_WL, sent.links[0].R_WL);
  EXPECT_EQ(got.links[0].p_LCm, sent.links[0].p_LCm);
  EXPECT_EQ(got.links[0].inertia_LCm, sent.links[0].inertia_LCm);
  EXPECT_TRUE(got.links[0].is_fixed);
  ASSERT_EQ(got.joints.size(), 1U);
  EXPECT_EQ(got.joints[0].type, "screw");
  EXPECT_EQ(got.joints[0].parent, "");
  EXPECT_EQ(got.joints[0].child, "arm");
  EXPECT_EQ(got.joints[0].point, sent.joints[0].point);
  EXPECT_EQ(got.joints[0].lead, -0.001);
  ASSERT_EQ(got.joints[0].axes.size(), 1U);
  const Axis& axis = got.joints[0].axes[0];
  EXPECT_EQ(axis.direction, sent.joints[0].axes[0].direction);
  EXPECT_FALSE(axis.lower);
  EXPECT_EQ(axis.upper, 0.1);
  EXPECT_EQ(axis.stop_stiffness, 2.0);
  EXPECT_EQ(axis.stop_damping, 3.0);
  EXPECT_EQ(axis.damping, 4.0);
  EXPECT_EQ(axis.friction, 5.0);
  EXPECT_EQ(axis.spring_stiffness, 6.0);
  EXPECT_EQ(axis.spring_reference, 7.0);
}

TEST(Exchange, BringsARefusal) {
  try {
    read_answer(refusal(Error("S014", "a.sdf:3:1", "no XML", "Repair it.")));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "S014");
    EXPECT_EQ(error.place(), "a.sdf:3:1");
    EXPECT_EQ(error.problem(), "no XML");
    EXPECT_EQ(error.remedy(), "Repair it.");
  }
}

TEST(Exchange, RefusesWhatIsNoAnswer) {
  EXPECT_THROW(read_answer(""), std::exception);
  EXPECT_THROW(read_answer("{}"), std::exception);
}

TEST(Exchange, PassesOnThatANumberIsNotFinite) {
  Model broken = model();
  broken.links[0].mass = std::numeric_limits<double>::quiet_NaN();
  broken.links[0].p_LCm.y() = std::numeric_limits<double>::infinity();
  const Model read = read_answer(answer(broken));
  EXPECT_FALSE(std::isfinite(read.links[0].mass));
  EXPECT_FALSE(read.links[0].p_LCm.allFinite());
}

}  // namespace
}  // namespace clevis::multibody
