#include "loads/seats/force_seats.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "loads/parts/part_loads.h"
#include "mechanism/simulate.h"
#include "support/free_linkages.h"
#include "support/reference_motions.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;
using namespace mechanism;

// Link P turns about A and carries a slide S on which rod Q moves. Every kind
// of force acts on P while it moves under all of them. That nothing is left
// out and no sign is wrong shows in the balance of each instant (L001): the
// reactions come from the equations of motion, the forces from the elements.
constexpr double kDiameter = 10e-3;

GroupGeometry cylinder(const std::string& name, const Vector3d& at,
                       const Vector3d& axis) {
  const part::Bore c{
      .p_LC = at, .axis_L = axis, .radius = 0.5 * kDiameter, .length = 8e-3};
  return {.name = name,
          .is_cylinder = true,
          .cylinder = c,
          .centroid = at,
          .area = 2.0 * std::numbers::pi * c.radius * c.length};
}

GroupGeometry face(const std::string& name, const Vector3d& at) {
  GroupGeometry face;
  face.name = name;
  face.centroid = at;
  face.area = 2e-4;
  return face;
}

LineElement on_joint_named(const std::string& name, int joint,
                           decltype(LineElement::law) law) {
  LineElement e = mechanism::testing::on_joint(joint, std::move(law));
  e.name = name;
  return e;
}

LineElement between(const std::string& name, ElementLine::Kind kind,
                    ElementPoint a, ElementPoint b, const SpringLaw& law) {
  LineElement e;
  e.name = name;
  e.line = {.kind = kind,
            .a = a,
            .b = b,
            .axis_L = Vector3d(1.0, 0.2, 0.0).normalized()};
  e.law = law;
  return e;
}

const Vector3d kSlide(0.03, 0.04, 0.0), kEye(0.1, 0.02, 0.01);

struct Loaded {
  MechanismDefinition definition;
  part::PartDefinition part;
  std::vector<GroupGeometry> groups;
  Motion motion;

  LoadHistory loads() const {
    return part_loads(definition, motion, 0, part, groups,
                      definition.bodies[0].mass_properties);
  }
  std::string code() const {
    try {
      loads();
    } catch (const Error& error) {
      return error.code();
    }
    return "none";
  }
};

GasCylinderLaw sealed_gas() {
  GasCylinderLaw law;
  GasChamber chamber;
  chamber.name = "cap";
  chamber.area = 1.5e-4;
  chamber.dead_volume = 1e-5;
  chamber.start = {600e3, 300.0};
  law.chambers = {chamber};
  return law;
}

void define_mechanism(MechanismDefinition& m) {
  m.gravity_W = {0.0, -9.81, 0.0};
  m.bodies = {mechanism::testing::uniform_bar("P", Vector3d::Zero(), 0.0, 0.2),
              mechanism::testing::uniform_bar("Q", kSlide, 0.0, 0.1)};
  m.joints = {mechanism::testing::pin("A", kGround, 0, 0.0, 0.0)};
  JointDefinition slide;
  slide.name = "S";
  slide.type = JointType::kPrismatic;
  slide.body_a = 0;
  slide.body_b = 1;
  slide.frame_a.R_LJ =
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitY())
          .toRotationMatrix();
  slide.frame_b = slide.frame_a;
  slide.frame_a.p_LJ = kSlide;
  m.joints.push_back(slide);
}

void add_forces(MechanismDefinition& m) {
  const SpringLaw spring{.stiffness = 300.0, .damping = 2.0, .free = 0.15};
  const ContactLaw hard{.stiffness = 2e4, .damping = 5.0};
  ContactElement contact;
  contact.name = "contact";
  contact.center = {0, {0.14, 0.0, 0.0}};
  contact.radius = 0.02;
  contact.plane = {-1, {0.0, -0.0199, 0.0}};
  contact.law = hard;
  contact.kinetic_friction = contact.static_friction = 0.3;
  ImpedanceElement hold;
  hold.name = "hold";
  hold.point = {0, {0.2, 0.0, 0.0}};
  hold.target_W = {0.19, 0.01, 0.0};
  hold.stiffness = 400.0;
  hold.damping = 3.0;
  m.elements = {
      on_joint_named("torsion", 0,
                     SpringLaw{.stiffness = 5.0, .damping = 0.2, .free = 0.1}),
      on_joint_named("rub", 1,
                     FrictionLaw{.model = FrictionModel::kRegularized,
                                 .breakaway = 3.0,
                                 .kinetic = 2.0,
                                 .regularizing_speed = 0.01}),
      between("strut", ElementLine::Kind::kDistance,
              {-1, Vector3d(0.2, 0.15, 0.0)}, {0, kEye}, spring),
      between("slide", ElementLine::Kind::kSlide, {0, kEye},
              {1, Vector3d(0.05, 0.01, 0.0)}, spring),
      on_joint_named("gas", 1, sealed_gas()),
      on_joint_named("stop", 1,
                     StopLaw{.lower = 1e-4, .upper = {}, .contact = hard}),
      contact,
      hold};
  ConstantForce wind;
  wind.name = "wind";
  wind.point = {0, {0.05, 0.01, 0.0}};
  wind.f_W = {3.0, -7.0, 0.0};
  wind.t_W = {0.0, 0.0, 0.4};
  m.elements.emplace_back(wind);
}

Loaded loaded_link() {
  Loaded s;
  define_mechanism(s.definition);
  add_forces(s.definition);
  s.groups = {cylinder("bore_A", {0.0, 0.0, 1e-3}, Vector3d::UnitZ()),
              cylinder("bore_eye", kEye, Vector3d::UnitZ()),
              cylinder("round_S", kSlide, Vector3d::UnitX()),
              face("cap", {0.06, 0.041, 0.0}), face("rim", {0.14, 0.0, 0.0})};
  s.part.name = "P";
  s.part.seats = {{"A", "bore_A"}, {"S", "round_S"}};
  s.part.seats[1].slide.length = s.groups[2].cylinder.length;
  s.part.force_seats = {{"torsion", "bore_A", {}},
                        {"rub", "round_S", {}},
                        {"strut", "bore_eye", {}},
                        {"slide", "bore_eye", {}},
                        {"gas", "cap", {"round_S"}, "cap"},
                        {"stop", "cap", {}},
                        {"contact", "rim", {}},
                        {"hold", "rim", {}},
                        {"wind", "rim", {}}};
  SimulationSettings settings;
  settings.duration = 0.05;
  settings.instants = 26;
  settings.motion = MotionKind::kDynamic;
  s.motion = simulate(s.definition, settings);
  return s;
}

// Index of the force's seat behind the two joints'.
constexpr std::size_t kTorsion = 2, kRub = 3, kStrut = 4, kGas = 6, kWind = 10;

TEST(ForceSeats, EveryForceIsInTheBalance) {
  const Loaded s = loaded_link();
  const LoadHistory history = s.loads();
  ASSERT_EQ(history.seats.size(), 11u);
  // all of them act
  for (std::size_t k = 0; k < history.seats.size(); ++k) {
    double largest = 0.0;
    for (const InstantLoad& instant : history.instants) {
      largest = std::max(largest, instant.wrenches[k].force.norm() +
                                      instant.wrenches[k].moment.norm());
    }
    EXPECT_GT(largest, 0.05) << history.seats[k].name;
  }
}

TEST(ForceSeats, AForceThatIsLeftOutIsMissed) {
  for (std::size_t k = 0; k < 8; ++k) {
    Loaded s = loaded_link();
    for (Instant& instant : s.motion.instants) {
      instant.elements[k].actions[0].f_W *= 1.001;
      instant.elements[k].actions[1].f_W *= 1.001;
      instant.elements[k].actions[0].t_W *= 1.001;
      instant.elements[k].actions[1].t_W *= 1.001;
    }
    EXPECT_EQ(s.code(), "L001") << k;
  }
}

TEST(ForceSeats, EffortsAreThoseOfTheLaws) {
  const Loaded s = loaded_link();
  const LoadHistory history = s.loads();
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const Instant& instant = s.motion.instants[i];
    const Pose& pose = instant.bodies[0].pose;
    const InstantLoad& load = history.instants[i];
    // on the bore about its axis: P is b of A
    EXPECT_NEAR(load.wrenches[kTorsion].moment.z(), instant.elements[0].effort,
                1e-12);
    EXPECT_NEAR(load.wrenches[kTorsion].force.norm(), 0.0, 1e-12);
    // P is a of S, the slide lies along its x
    EXPECT_NEAR(load.wrenches[kRub].force.x(), -instant.elements[1].effort,
                1e-12);
    EXPECT_NEAR(load.wrenches[kGas].force.x(), -instant.elements[4].effort,
                1e-9);
    // the strut pulls its eye towards its foot
    const Vector3d to_foot =
        Vector3d(0.2, 0.15, 0.0) - (pose.p_WL + pose.R_WL * kEye);
    const Vector3d pull = -instant.elements[2].effort *
                          (pose.R_WL.transpose() * to_foot.normalized());
    EXPECT_LT((load.wrenches[kStrut].force - pull).norm(), 1e-12);
    EXPECT_LT(load.wrenches[kStrut].moment.norm(), 1e-12);
    EXPECT_LT(
        (pose.R_WL * load.wrenches[kWind].force - Vector3d(3.0, -7.0, 0.0))
            .norm(),
        1e-12);
  }
}

TEST(ForceSeats, WallFeelsTheGas) {
  const Loaded s = loaded_link();
  const LoadHistory history = s.loads();
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const auto& load = history.instants[i].surface_loads.at(0);
    EXPECT_EQ(load.group, "round_S");
    const auto& chamber = s.motion.instants[i].elements[4].chambers[0];
    EXPECT_NEAR(load.pressure, chamber.pressure - 101325.0, 1e-6);
  }
  EXPECT_GT(history.instants[0].surface_loads[0].pressure, 4e5);
}

TEST(ForceSeats, AForceWithoutSeatIsRefused) {
  Loaded s = loaded_link();
  for (std::size_t k = 0; k < 9; ++k) {
    Loaded without = s;
    without.part.force_seats.erase(without.part.force_seats.begin() +
                                   static_cast<std::ptrdiff_t>(k));
    EXPECT_EQ(without.code(), "L004") << k;
  }
  s.part.force_seats[0].force = "wave";
  EXPECT_EQ(s.code(), "L004");
}

TEST(ForceSeats, ABoreMustLieOnTheJointOfItsForce) {
  Loaded s = loaded_link();
  s.part.force_seats[0].group = "bore_eye";
  EXPECT_EQ(s.code(), "L003");
}

}  // namespace
}  // namespace clevis::loads
