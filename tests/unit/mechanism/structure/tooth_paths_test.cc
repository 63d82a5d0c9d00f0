#include "mechanism/structure/tooth_paths.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

/// A mechanism of joints alone; the last two are coupled.
class Scene {
 public:
  explicit Scene(std::size_t bodies) { definition_.bodies.resize(bodies); }
  Scene& joint(const std::string& name, JointType type, BodyIndex a,
               BodyIndex b) {
    JointDefinition joint;
    joint.name = name;
    joint.type = type;
    joint.body_a = a;
    joint.body_b = b;
    definition_.joints.push_back(joint);
    return *this;
  }
  /// @param open  joint whose reaction is not unique, or none.
  std::vector<std::string> lacking(const std::string& open = "") const {
    Motion motion;
    Instant& instant = motion.instants.emplace_back();
    for (const JointDefinition& joint : definition_.joints) {
      instant.joints.emplace_back().unique = joint.name != open;
    }
    MechanismDefinition definition = definition_;
    CouplingDefinition& coupling = definition.couplings.emplace_back();
    coupling.joint_1 = static_cast<int>(definition.joints.size()) - 2;
    coupling.joint_2 = coupling.joint_1 + 1;
    instant.couplings = {teeth};
    if (teeth.teeth) coupling.teeth.emplace();
    std::vector<std::string> names;
    for (const std::size_t j : joints_without_teeth(definition, motion, 0)) {
      names.push_back(definition.joints[j].name);
    }
    return names;
  }
  CouplingState teeth;

 private:
  MechanismDefinition definition_;
};

using Names = std::vector<std::string>;
constexpr auto kRevolute = JointType::kRevolute;
constexpr auto kWeld = JointType::kWeld;

// A four-bar whose crank is a wheel: its bearing and the pinion's take all.
TEST(ToothPaths, WheelsOnOneBodyLoadTheirBearingsAlone) {
  Scene scene(4);
  scene.joint("crank", kRevolute, 0, 1)
      .joint("coupler", kRevolute, 1, 2)
      .joint("rocker", kRevolute, 2, kGround)
      .joint("wheel", kRevolute, kGround, 0)
      .joint("pinion", kRevolute, 3, kGround);
  EXPECT_EQ(scene.lacking(), (Names{"wheel", "pinion"}));
  // What equilibrium leaves open of a bearing the linkage may hold.
  EXPECT_EQ(scene.lacking("wheel"),
            (Names{"crank", "coupler", "rocker", "wheel", "pinion"}));
}

// Teeth press two hubs apart, and what is between them carries that.
TEST(ToothPaths, WheelsOnTwoBodiesLoadWhatIsBetweenThese) {
  const BodyIndex hub = 0, other = 1, frame = 2, wheel = 3, pinion = 4;
  Scene scene(5);
  scene.joint("base", kWeld, kGround, hub)
      .joint("weld", kWeld, frame, hub)
      .joint("other weld", kWeld, frame, other)
      .joint("wheel", kRevolute, hub, wheel)
      .joint("pinion", kRevolute, pinion, other);
  EXPECT_EQ(scene.lacking(), (Names{"weld", "other weld", "wheel", "pinion"}));
}

// A rack on the ground and its pinion on a bracket.
TEST(ToothPaths, RackLoadsWhatHoldsItsPinion) {
  const BodyIndex bracket = 0, hub = 1, pinion = 2, rack = 3;
  Scene scene(4);
  scene.joint("foot", kWeld, kGround, bracket)
      .joint("head", kWeld, bracket, hub)
      .joint("rack", JointType::kPrismatic, kGround, rack)
      .joint("pinion", kRevolute, hub, pinion);
  EXPECT_EQ(scene.lacking(), (Names{"foot", "head", "rack", "pinion"}));
}

// A ball takes no moment: a shaft's far bearing takes teeth's forces, too.
TEST(ToothPaths, BallLeavesTeethToOtherJoints) {
  const BodyIndex shaft = 0, journal = 1, pinion = 2, wheel = 3;
  Scene scene(4);
  scene.joint("wheel", kWeld, shaft, wheel)
      .joint("journal", kWeld, journal, shaft)
      .joint("far", JointType::kPointOnLine, kGround, shaft)
      .joint("pinion", kRevolute, kGround, pinion)
      .joint("ball", JointType::kSpherical, kGround, journal);
  EXPECT_EQ(scene.lacking(), (Names{"journal", "far", "pinion", "ball"}));
}

/// Two wheels on the ground.
Scene gears() {
  Scene scene(3);
  scene.joint("other", kRevolute, kGround, 2)
      .joint("wheel", kRevolute, kGround, 0)
      .joint("pinion", kRevolute, kGround, 1);
  scene.teeth.teeth.emplace();
  return scene;
}

TEST(ToothPaths, ResolvedTeethLackNowhere) {
  Scene scene = gears();
  EXPECT_EQ(scene.lacking(), Names{});
  scene.teeth.unique = false;
  EXPECT_EQ(scene.lacking(), (Names{"wheel", "pinion"}));
}

}  // namespace
}  // namespace clevis::mechanism
