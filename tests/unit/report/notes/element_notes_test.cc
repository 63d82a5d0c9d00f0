#include "report/notes/element_notes.h"

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

using namespace mechanism;

/// A bar of 100 mm on a slide, an element between it and ground, and two
/// instants.
struct Slide {
  MechanismDefinition definition;
  Motion motion;

  explicit Slide(const ForceElement& element) {
    definition.bodies.resize(1);
    definition.bodies[0].name = "bar";
    definition.joints.resize(1);
    definition.joints[0].type = JointType::kPrismatic;
    definition.joints[0].body_a = kGround;
    definition.joints[0].body_b = 0;
    definition.joints[0].frame_b.p_LJ = {0.1, 0.0, 0.0};
    definition.elements = {element};
    motion.instants.resize(2);
    motion.instants[1].t = 2.0;
    for (Instant& instant : motion.instants) {
      instant.bodies.resize(1);
      instant.joints.resize(1);
      instant.elements.resize(1);
    }
  }

  ElementState& at(std::size_t instant) {
    return motion.instants[instant].elements[0];
  }
  /// Positions at both instants.
  void move(double first, double second) {
    at(0).position = first;
    at(1).position = second;
  }
  void push(double force) {
    for (std::size_t i = 0; i < 2; ++i) {
      at(i).effort = force;
      at(i).actions[1] = {.body = 0, .f_W = {force, 0.0, 0.0}};
    }
  }
  std::string note() const {
    std::vector<std::string> notes;
    add_element_notes(definition, motion, notes);
    EXPECT_LE(notes.size(), 1u);
    return notes.empty() ? "" : notes.front();
  }
};

ForceElement line(const LineLaw& law) {
  LineElement element;
  element.name = "one";
  element.line.joint = 0;
  element.law = law;
  return element;
}

TEST(ElementNotes, StopThatIsNeverReachedIsTold) {
  Slide slide(line(StopLaw{.lower = -0.02, .upper = 100.0}));
  slide.move(0.04, 0.0);
  EXPECT_EQ(slide.note(), "");  // the lower end is near
  slide.definition.elements = {line(StopLaw{.upper = 100.0})};
  EXPECT_EQ(slide.note(),
            "stop one never presses over the whole motion: it comes no nearer "
            "than 9.996e+04 mm, while it moves by 40 mm. See that its place, "
            "its direction and their units are right");
  slide.motion.impacts = {{.element = 0}};  // between the instants
  EXPECT_EQ(slide.note(), "");
  slide.motion.impacts.clear();
  slide.push(-5.0);
  EXPECT_EQ(slide.note(), "");
}

TEST(ElementNotes, ContactThatIsLeftBehindIsTold) {
  ContactElement contact;
  contact.name = "wheel";
  contact.radius = 0.02;
  Slide slide(contact);
  slide.move(-0.03, -0.2);
  EXPECT_NE(slide.note().find("than 30 mm, where it begins"), std::string::npos)
      << slide.note();
  slide.move(-0.2, -0.03);  // falls, and does not arrive
  EXPECT_EQ(slide.note(), "");
}

TEST(ElementNotes, EffortOverTimeThatBeginsTooLateIsTold) {
  Slide slide(line(TableLaw{.times = {6.0, 7.0}, .efforts = {0.0, 1.0}}));
  EXPECT_NE(slide.note().find("table one gives no effort over the whole motion "
                              "of 2 s"),
            std::string::npos)
      << slide.note();
  slide.at(1).effort = 1e-9;
  EXPECT_EQ(slide.note(), "");
  EXPECT_EQ(Slide(line(SpringLaw{})).note(), "");  // at rest
}

TEST(ElementNotes, DepthBeyondWhatPressesIsTold) {
  ContactElement contact;
  contact.name = "wheel";
  contact.radius = 0.02;
  Slide slide(contact);
  slide.push(1.0);
  slide.move(-0.01, 0.019);
  EXPECT_EQ(slide.note(), "");
  slide.move(-0.01, 0.021);
  EXPECT_EQ(slide.note(),
            "contact wheel is pressed 21 mm deep at 2 s, deeper than its "
            "radius of 20 mm: see that its stiffness is right");
  slide.move(0.12, 0.0);
  EXPECT_EQ(slide.note(),
            "contact wheel is 120 mm deep at the start, deeper than its radius "
            "of 20 mm: see that its place and its direction are right");
  // Of a stop by its range, or by the mechanism's size.
  slide.definition.elements = {line(StopLaw{.lower = 0.0, .upper = 0.03})};
  slide.move(0.0, 0.062);
  EXPECT_NE(slide.note().find("32 mm deep at 2 s, deeper than the range "
                              "between its ends of 30 mm"),
            std::string::npos)
      << slide.note();
  slide.definition.elements = {line(StopLaw{.upper = 0.03})};
  EXPECT_EQ(slide.note(), "");
  slide.move(0.0, 0.529);  // a cord
  EXPECT_EQ(slide.note(), "");
  slide.move(0.0, 0.531);
  EXPECT_NE(slide.note().find("deeper than five times the mechanism's size, "
                              "500 mm"),
            std::string::npos)
      << slide.note();
}

TEST(ElementNotes, SpringStretchedToManySizesIsTold) {
  Slide slide(line(SpringLaw{.stiffness = 100.0, .free = 1.5}));
  slide.push(1.0);
  slide.move(0.51, 0.6);
  EXPECT_EQ(slide.note(), "");
  slide.move(0.4, 0.6);
  EXPECT_NE(slide.note().find("spring one is 1100 mm off the position where it "
                              "gives no force, 11 times"),
            std::string::npos)
      << slide.note();
}

TEST(ElementNotes, ForceFarOffItsBodyIsTold) {
  ConstantForce force;
  force.name = "push";
  Slide slide(force);
  slide.push(1.0);
  EXPECT_EQ(slide.note(), "");
  slide.at(1).actions[1].p_W = {0.0, 40.0, 0.0};
  EXPECT_NE(slide.note().find("constant push acts 4e+04 mm from the centre of "
                              "mass of body bar, 400 times"),
            std::string::npos)
      << slide.note();
}

TEST(ElementNotes, FrictionThatNoSurfaceHasIsTold) {
  Slide slide(line(FrictionLaw{.breakaway = 2.1, .follows_reaction = true}));
  EXPECT_NE(slide.note().find("friction of 2.1"), std::string::npos)
      << slide.note();
  slide.definition.elements = {line(FrictionLaw{.breakaway = 2.1})};  // N
  EXPECT_EQ(slide.note(), "");
  // In a hinge its arm [m] is compared.
  slide.definition.joints[0].type = JointType::kRevolute;
  slide.definition.elements = {
      line(FrictionLaw{.breakaway = 0.031, .follows_reaction = true})};
  EXPECT_NE(slide.note().find("holds against 31 N mm"), std::string::npos)
      << slide.note();
  slide.definition.elements = {
      line(FrictionLaw{.breakaway = 0.029, .follows_reaction = true})};
  EXPECT_EQ(slide.note(), "");
}

// 0.4 N m beside 20 N: a guide of 40 mm carries both with nothing to spare.
TEST(ElementNotes, MomentThatFrictionDoesNotFollowIsTold) {
  Slide slide(line(FrictionLaw{.breakaway = 0.1, .follows_reaction = true}));
  JointReaction& reaction = slide.motion.instants[1].joints[0];
  reaction.f_W = {12.0, 16.0, 700.0};  // the last along the slide
  EXPECT_EQ(slide.note(), "");
  reaction.t_W = {0.4, 0.0, 9.0};
  EXPECT_NE(slide.note().find("20 N, not the moment across it, 0.4 N m, with "
                              "which a guide shorter than 40 mm presses"),
            std::string::npos)
      << slide.note();
  reaction.t_W *= 0.1;  // 4 mm of 100
  EXPECT_EQ(slide.note(), "");
  reaction.f_W.setZero();
  EXPECT_NE(slide.note().find("any guide"), std::string::npos);
  slide.definition.elements = {line(FrictionLaw{.breakaway = 0.1})};
  EXPECT_EQ(slide.note(), "");
  slide.definition.elements = {line(FrictionLaw{
      .breakaway = 0.1, .follows_reaction = true, .guide = {0.02, true}})};
  EXPECT_EQ(slide.note(), "");
}

TEST(ElementNotes, GasThatIsNoneAnyMoreIsTold) {
  Slide slide(line(GasCylinderLaw{}));
  slide.push(1.0);
  slide.at(1).chambers = {{.pressure = 5e5, .temperature = 300.0}};
  EXPECT_EQ(slide.note(), "");
  slide.at(1).chambers[0].temperature = 59024.0;
  EXPECT_NE(slide.note().find("0.5 MPa and 5.902e+04 K at 2 s"),
            std::string::npos)
      << slide.note();
  slide.at(1).chambers[0] = {.pressure = 0.5, .temperature = 300.0};
  EXPECT_NE(slide.note(), "");
}

}  // namespace
}  // namespace clevis::report
