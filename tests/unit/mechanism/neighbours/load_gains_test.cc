// What loads gain as a body gives way at its joints, against statics by hand.
#include "mechanism/neighbours/load_gains.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double kLength = 0.1;   // of the link, along x [m]
constexpr double kForce = 200.0;  // presses [N]
constexpr double kGain = kForce / kLength;
constexpr double kRoundOff = 1e-9;

BodyDefinition bar(const Vector3d& centre) {
  BodyDefinition body;
  body.mass_properties = {.mass = 0.1, .p_LCm = centre};
  body.mass_properties.inertia_LCm = 1e-4 * Matrix3d::Identity();
  return body;
}

JointDefinition joint(JointType type, BodyIndex a, BodyIndex b, double at) {
  JointDefinition joint{.type = type, .body_a = a, .body_b = b};
  joint.frame_a.p_LJ = joint.frame_b.p_LJ = at * Vector3d::UnitX();
  return joint;
}

/// Body 0 and link 1 meet in the origin, link and ground at its other end; the
/// link presses on the body.
struct Linked {
  MechanismDefinition definition;
  Instant instant;

  explicit Linked(JointType near, JointType far = JointType::kSpherical) {
    definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0)),
                         bar(Vector3d(0.05, 0.0, 0.0))};
    definition.joints = {joint(near, 0, 1, 0.0),
                         joint(far, kGround, 1, kLength)};
    instant.bodies.resize(2);
    instant.joints.resize(2);
    press({kForce, 0.0, 0.0});
  }
  /// The body's force on the link, which the ground holds.
  void press(const Vector3d& force) {
    instant.joints[0].f_W = force;
    instant.joints[1].f_W = -force;
    instant.joints[1].p_WJ = kLength * Vector3d::UnitX();
  }
  MatrixXd found(const Vector3d& p_LS = Vector3d::Zero()) const {
    return load_gains(Neighbours(definition, 0), instant,
                      {{LoadPlace::Kind::kJoint, 0, p_LS}});
  }
};

Matrix3d of_displacements(const MatrixXd& gains) {
  return gains.topLeftCorner<3, 3>();
}

TEST(LoadGains, LinkThatPressesPushesOnAcross) {
  for (const double sign : {1.0, -1.0}) {
    Linked linked(JointType::kSpherical);
    linked.press({sign * kForce, 0.0, 0.0});
    const Matrix3d wanted = Vector3d(0.0, sign, sign).asDiagonal();
    const auto found = linked.found();
    EXPECT_LT((of_displacements(found) - kGain * wanted).norm(),
              kRoundOff * kGain);
    EXPECT_LT(found.bottomRows(3).norm(), kRoundOff * kForce);
  }
}

// Other forces on a link, and a nut on it, do not take that from it.
TEST(LoadGains, LoadsOnTheLinkDoNotMatter) {
  Linked linked(JointType::kSpherical);
  ConstantForce across;
  linked.definition.elements = {across};
  linked.definition.bodies.push_back(bar(Vector3d(0.03, 0.0, 0.0)));
  linked.definition.joints.push_back(joint(JointType::kWeld, 1, 2, 0.03));
  linked.instant.bodies.resize(3);
  linked.instant.joints.resize(3);
  linked.instant.joints[2].p_WJ = 0.03 * Vector3d::UnitX();
  linked.press({kForce, -15.0, 0.0});
  linked.instant.joints[1].f_W.y() = -15.0;
  ElementState state;
  state.actions[1] = {.body = 1,
                      .p_W = 0.05 * Vector3d::UnitX(),
                      .f_W = Vector3d(0.0, 30.0, 0.0)};
  linked.instant.elements = {state};
  const Matrix3d found = of_displacements(linked.found());
  EXPECT_NEAR(found(1, 1), kGain, 1e-6 * kGain);
  EXPECT_NEAR(found(2, 2), kGain, 1e-6 * kGain);
}

TEST(LoadGains, HingesLetALinkSwingAboutTheirAxisOnly) {
  const Matrix3d wanted = Vector3d(0.0, kGain, 0.0).asDiagonal();
  EXPECT_LT((of_displacements(
                 Linked(JointType::kRevolute, JointType::kRevolute).found()) -
             wanted)
                .norm(),
            kRoundOff * kGain);
}

TEST(LoadGains, OfAWeldToWhatIsHeldNone) {
  const auto found = Linked(JointType::kWeld, JointType::kWeld)
                         .found(Vector3d(-0.05, 0.01, 0.0));
  EXPECT_LT(found.norm(), kRoundOff * kForce);
}

TEST(LoadGains, OfADrivenCrankAtItsDeadCentreNone) {
  Linked linked(JointType::kRevolute, JointType::kRevolute);
  linked.definition.drives = {{.joint = 1}};
  linked.instant.drives.resize(1);
  EXPECT_LT(linked.found().norm(), kRoundOff * kForce);
}

TEST(LoadGains, TurnWithTheBody) {
  const Matrix3d wanted = of_displacements(
      Linked(JointType::kRevolute, JointType::kRevolute).found());
  Linked linked(JointType::kRevolute, JointType::kRevolute);
  const Matrix3d turned(
      Eigen::AngleAxisd(std::numbers::pi / 6.0, Vector3d::UnitZ()));
  linked.instant.bodies[0].pose.R_WL = turned;
  linked.definition.joints[0].frame_a.R_LJ = turned.transpose();
  EXPECT_LT(
      (of_displacements(linked.found()) - turned.transpose() * wanted * turned)
          .norm(),
      kRoundOff * kGain);
}

// Two bodies that slide on each other, pushed apart, are one link to who leans
// on them, and let him come nearer.
// Wherever the frames of the slide are along it.
class LoadGainsOfACylinder : public ::testing::TestWithParam<double> {};

TEST_P(LoadGainsOfACylinder, PushesOnAcross) {
  const double on_tube = GetParam();
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0)),
                       bar(Vector3d(0.03, 0.0, 0.0)),
                       bar(Vector3d(0.08, 0.0, 0.0))};
  definition.joints = {joint(JointType::kSpherical, 0, 1, 0.0),
                       joint(JointType::kPrismatic, 2, 1, 0.05),
                       joint(JointType::kSpherical, kGround, 2, kLength)};
  for (JointFrame* frame :
       {&definition.joints[1].frame_a, &definition.joints[1].frame_b}) {
    frame->R_LJ.col(0) = Vector3d::UnitY();
    frame->R_LJ.col(1) = Vector3d::UnitZ();
    frame->R_LJ.col(2) = Vector3d::UnitX();
  }
  definition.joints[1].frame_a.p_LJ.x() = on_tube;
  LineElement spring;
  spring.line = {.kind = ElementLine::Kind::kJoint, .joint = 1};
  definition.elements = {spring};
  Instant instant;
  instant.bodies.resize(3);
  instant.joints.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    instant.joints[k].p_WJ = 0.05 * static_cast<double>(k) * Vector3d::UnitX();
  }
  const Vector3d force = kForce * Vector3d::UnitX();
  instant.joints[0].f_W = force;
  instant.joints[2].f_W = -force;
  ElementState state;
  state.actions[0] = {
      .body = 2, .p_W = on_tube * Vector3d::UnitX(), .f_W = force};
  state.actions[1] = {.body = 1, .p_W = instant.joints[1].p_WJ, .f_W = -force};
  instant.elements = {state};
  const auto found =
      load_gains(Neighbours(definition, 0), instant,
                 {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()}});
  const Matrix3d wanted = Vector3d(0.0, kGain, kGain).asDiagonal();
  EXPECT_LT((of_displacements(found) - wanted).norm(), 1e-6 * kGain);
}

INSTANTIATE_TEST_SUITE_P(Slides, LoadGainsOfACylinder,
                         ::testing::Values(0.05, 0.1, -0.02));

/// A body that is welded to body 0 at the origin under a force.
MatrixXd of_mast(const Vector3d& at, const Vector3d& force,
                 const Vector3d& p_LS = Vector3d::Zero()) {
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0)),
                       bar(Vector3d(0.05, 0.0, 0.0))};
  definition.joints = {joint(JointType::kWeld, 0, 1, 0.0)};
  definition.elements = {ConstantForce{}};
  Instant instant;
  instant.bodies.resize(2);
  instant.joints.resize(1);
  instant.joints[0].f_W = -force;
  instant.joints[0].t_W = -at.cross(force);
  ElementState state;
  state.actions[1] = {.body = 1, .p_W = at, .f_W = force};
  instant.elements = {state};
  return load_gains(Neighbours(definition, 0), instant,
                    {{LoadPlace::Kind::kJoint, 0, p_LS}});
}

// A weight on a mast turns it further; wherever the weld is.
TEST(LoadGains, LoadOnAMastHasAnArm) {
  const Vector3d p_LS(-0.02, 0.0, 0.0);
  const auto found = of_mast({0.3, 0.0, 0.0}, {-kForce, 0.0, 0.0}, p_LS);
  const double moment = kForce * 0.32;
  const Matrix3d wanted = Vector3d(0.0, moment, moment).asDiagonal();
  EXPECT_LT((found.bottomRightCorner<3, 3>() - wanted).norm(),
            kRoundOff * moment);
  EXPECT_LT(found.topRows(3).norm(), kRoundOff * kForce);
}

// On a ball with a bushing that it cannot push over it turns with the body, and
// further as that yields under the factor wanted, or under the loads as they
// are where it topples before; on one that it can push over it does not follow.
TEST(LoadGains, MastOnABushingFollowsWhereThatHolds) {
  constexpr double kArm = 0.3;
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0)),
                       bar(Vector3d(0.05, 0.0, 0.0))};
  definition.joints = {joint(JointType::kSpherical, 0, 1, 0.0)};
  Instant instant;
  instant.bodies.resize(2);
  instant.joints.resize(1);
  const Vector3d force(-kForce, 0.0, 0.0);
  instant.joints[0].f_W = -force;
  ElementState held, pressed;
  held.actions[0].body = 0;
  held.actions[1].body = 1;
  pressed.actions[1] = {
      .body = 1, .p_W = kArm * Vector3d::UnitX(), .f_W = force};
  instant.elements = {held, pressed};
  constexpr double kMoment = kForce * kArm;
  for (const double stiffness : {1e6, 5.0 * kMoment, 0.1 * kMoment}) {
    BushingElement bushing;
    bushing.a.body = 0;
    bushing.b.body = 1;
    bushing.stiffness.bottomRightCorner<3, 3>() =
        stiffness * Matrix3d::Identity();
    definition.elements = {bushing, ConstantForce{}};
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(12);
    turn[5] = turn[11] = 1.0;
    for (const double wanted : {1.5, 3.0, 6.0}) {
      const auto found =
          load_gains(Neighbours(definition, 0), instant,
                     {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()},
                      {LoadPlace::Kind::kElement, 0, Vector3d::Zero()}},
                     wanted);
      const double factor = wanted * kMoment < stiffness ? wanted : 1.0;
      const double yields = 1.0 / (1.0 - factor * kMoment / stiffness);
      EXPECT_NEAR(turn.dot(found * turn),
                  stiffness > kMoment ? kMoment * yields : 0.0, 1e-6 * kForce);
    }
  }
}

// −θ×(θ×r)·f/2 of a force across the mast: turns about both axes couple.
TEST(LoadGains, LoadAcrossAMastCouplesItsTurns) {
  const auto found = of_mast({0.3, 0.0, 0.0}, {0.0, kForce, 0.0});
  Matrix3d wanted = Matrix3d::Zero();
  wanted(0, 1) = wanted(1, 0) = 0.5 * 0.3 * kForce;
  EXPECT_LT((found.bottomRightCorner<3, 3>() - wanted).norm(),
            kRoundOff * kForce);
}

// A wheel that stands on the ground touches it below its centre, however the
// body turns that it is part of.
TEST(LoadGains, OfAWheelGoesThroughItsCentre) {
  constexpr double kRadius = 0.1, kAxle = 0.3;
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0)),
                       bar(Vector3d(0.05, 0.0, 0.0))};
  definition.joints = {joint(JointType::kWeld, 0, 1, 0.0)};
  ContactElement contact;
  contact.center = {1, kAxle * Vector3d::UnitX()};
  contact.radius = kRadius;
  contact.normal_L = -Vector3d::UnitX();
  definition.elements = {contact};
  Instant instant;
  instant.bodies.resize(2);
  instant.joints.resize(1);
  const Vector3d force = -kForce * Vector3d::UnitX();
  instant.joints[0].f_W = -force;
  const Vector3d touch = (kAxle + kRadius) * Vector3d::UnitX();
  ElementState state;
  state.actions[0] = {.body = kGround, .p_W = touch, .f_W = -force};
  state.actions[1] = {.body = 1, .p_W = touch, .f_W = force};
  instant.elements = {state};
  const auto found =
      load_gains(Neighbours(definition, 0), instant,
                 {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()}});
  EXPECT_NEAR(found(5, 5), kForce * kAxle, kRoundOff * kForce);
}

// A pinion on a mast, a rack across its top: what presses them apart goes
// through the pinion's centre, what turns them stays beside it.
TEST(LoadGains, OfTeethGoThroughTheWheelsCentre) {
  constexpr double kRadius = 0.1, kAxle = 0.3, kAcross = 70.0;
  MechanismDefinition definition;
  definition.bodies = {
      bar(Vector3d(-0.1, 0.0, 0.0)), bar(Vector3d(0.05, 0.0, 0.0)),
      bar(Vector3d(kAxle - 0.05, 0.01, 0.0)), bar(Vector3d(kAxle, 0.0, 0.0))};
  definition.joints = {joint(JointType::kWeld, 0, 1, 0.0),
                       joint(JointType::kWeld, kGround, 0, -0.1),
                       joint(JointType::kPrismatic, kGround, 3, kAxle),
                       joint(JointType::kRevolute, 1, 2, kAxle)};
  const Matrix3d across(
      Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vector3d::UnitX()));
  definition.joints[2].frame_a.R_LJ = definition.joints[2].frame_b.R_LJ =
      across;
  CouplingDefinition& mesh = definition.couplings.emplace_back();
  mesh.joint_1 = 2;
  mesh.joint_2 = 3;
  mesh.ratio = kRadius;
  mesh.teeth.emplace().pressure_angle = std::atan(kForce / kAcross);
  definition.drives = {{.joint = 3}};
  Instant instant;
  instant.bodies.resize(4);
  instant.joints.resize(4);
  instant.drives.resize(1);
  const Vector3d on_rack(kForce, kAcross, 0.0);
  CouplingState& state = instant.couplings.emplace_back();
  state.effort = kAcross;
  state.teeth =
      ToothForce{.f_W = on_rack, .p_W = (kAxle + kRadius) * Vector3d::UnitX()};
  instant.drives[0].effort = kRadius * kAcross;
  instant.joints[0].f_W = instant.joints[3].f_W = on_rack;
  instant.joints[0].t_W.z() = (kAxle + kRadius) * kAcross;
  instant.joints[2].f_W.x() = -kForce;
  const auto found =
      load_gains(Neighbours(definition, 0), instant,
                 {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()}});
  EXPECT_NEAR(found(5, 5), kForce * kAxle, kRoundOff * kForce);
}

// A housing of two wheels whose torques their drives put on it: as it turns as
// a whole all that acts between its bodies turns with it.
TEST(LoadGains, OfTeethOnOneHousingThatTurnsNone) {
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d::Zero()), bar(Vector3d(0.12, 0.01, 0.0)),
                       bar(Vector3d(0.37, -0.02, 0.0))};
  definition.joints = {joint(JointType::kRevolute, 0, 1, 0.1),
                       joint(JointType::kRevolute, 0, 2, 0.4)};
  CouplingDefinition& mesh = definition.couplings.emplace_back();
  mesh.joint_2 = 1;
  mesh.ratio = -2.0;  // wheels of 0.1 and 0.2 m
  mesh.teeth.emplace().pressure_angle = 0.35;
  definition.drives = {{.joint = 0}, {.joint = 1}};
  const Vector3d on_first(-kForce * std::tan(0.35), kForce, 0.0);
  Instant instant;
  instant.bodies.resize(3);
  instant.joints.resize(2);
  instant.drives.resize(2);
  CouplingState& state = instant.couplings.emplace_back();
  state.effort = 0.1 * kForce;
  state.teeth = ToothForce{.f_W = on_first, .p_W = Vector3d(0.2, 0.0, 0.0)};
  instant.joints[0].f_W = -on_first;
  instant.joints[1].f_W = on_first;
  instant.drives[0].effort = -0.1 * kForce;
  instant.drives[1].effort = -0.2 * kForce;
  const std::vector<LoadPlace> places{
      {LoadPlace::Kind::kJoint, 0, Vector3d(0.1, 0.0, 0.0)},
      {LoadPlace::Kind::kJoint, 1, Vector3d(0.4, 0.0, 0.0)}};
  const MatrixXd gains = load_gains(Neighbours(definition, 0), instant, places);
  Eigen::VectorXd turned = Eigen::VectorXd::Zero(12);
  for (Eigen::Index k = 0; k < 2; ++k) {
    turned[6 * k + 1] = places[static_cast<std::size_t>(k)].p_LS.x();
    turned[6 * k + 5] = 1.0;
  }
  EXPECT_NEAR(turned.dot(gains * turned), 0.0, kRoundOff * kForce);
  EXPECT_GT(gains.norm(), 1e-3 * kForce);
}

// A bushing's force keeps its direction in body a, where it acts at b's point.
TEST(LoadGains, OfABushingTurnsWithItsFirstBody) {
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0))};
  definition.elements = {BushingElement{}};
  Instant instant;
  instant.bodies.resize(1);
  const Vector3d at(0.3, 0.0, 0.0), force(-kForce, 0.0, 0.0);
  ElementState state;
  state.actions[0] = {.body = 0, .p_W = at, .f_W = force};
  state.actions[1] = {.body = kGround, .p_W = at, .f_W = -force};
  instant.elements = {state};
  const std::vector<LoadPlace> places{
      {LoadPlace::Kind::kElement, 0, Vector3d::Zero()}};
  const auto found = load_gains(Neighbours(definition, 0), instant, places);
  // −F e(θ) at a fixed point in space: across F θ, and of its arm h as well.
  EXPECT_NEAR(found(5, 5), -kForce * 0.3, kRoundOff * kForce);
  EXPECT_NEAR(found(1, 5), -kForce, kRoundOff * kForce);
  definition.elements = {ConstantForce{}};
  const auto dead = load_gains(Neighbours(definition, 0), instant, places);
  EXPECT_NEAR(dead(5, 5), kForce * 0.3, kRoundOff * kForce);
}

// A weight that hangs on a pendulum hangs straight again; one that stands on
// its pin pushes on.
TEST(LoadGains, PendulumHangsStraightUnderItsPin) {
  for (const double sign : {1.0, -1.0}) {
    MechanismDefinition definition;
    definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0)),
                         bar(Vector3d(0.05, 0.0, 0.0))};
    definition.bodies[1].mass_properties.inertia_LCm *= 1e-3;
    definition.joints = {joint(JointType::kSpherical, 0, 1, 0.0)};
    Instant instant;
    instant.bodies.resize(2);
    instant.joints.resize(1);  // the weight is at the body's centre
    instant.joints[0].f_W = -sign * kForce * Vector3d::UnitX();
    const auto found =
        load_gains(Neighbours(definition, 0), instant,
                   {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()}});
    const double wanted = sign > 0.0 ? 0.0 : kForce / 0.05;
    EXPECT_NEAR(found(1, 1), wanted, 2e-3 * kForce / 0.05);
  }
}

// A rod of given length, and a ram between two points.
TEST(LoadGains, RodsAndRams) {
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d(-0.1, 0.0, 0.0))};
  JointDefinition rod = joint(JointType::kDistance, 0, kGround, 0.0);
  rod.frame_b.p_LJ = kLength * Vector3d::UnitX();
  rod.length = kLength;
  definition.joints = {rod};
  Instant instant;
  instant.bodies.resize(1);
  instant.joints.resize(1);
  instant.joints[0].f_W = kForce * Vector3d::UnitX();
  instant.joints[0].p_WJ = rod.frame_b.p_LJ;
  const Matrix3d wanted = Vector3d(0.0, kGain, kGain).asDiagonal();
  const auto of_rod =
      load_gains(Neighbours(definition, 0), instant,
                 {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()}});
  EXPECT_LT((of_displacements(of_rod) - wanted).norm(), kRoundOff * kGain);

  LineElement ram;
  ram.line = {.kind = ElementLine::Kind::kDistance,
              .a = {0, Vector3d::Zero()},
              .b = {kGround, kLength * Vector3d::UnitX()}};
  definition.joints.clear();
  definition.elements = {ram};
  instant.joints.clear();
  ElementState state;
  state.actions[0] = {.body = 0, .f_W = -kForce * Vector3d::UnitX()};
  state.actions[1] = {.body = kGround,
                      .p_W = kLength * Vector3d::UnitX(),
                      .f_W = kForce * Vector3d::UnitX()};
  instant.elements = {state};
  const auto of_ram =
      load_gains(Neighbours(definition, 0), instant,
                 {{LoadPlace::Kind::kElement, 0, Vector3d::Zero()}});
  EXPECT_LT((of_displacements(of_ram) - wanted).norm(), kRoundOff * kGain);
}

// A rod in a guide, pushed along it on its end by a drive or by a force on the
// joint: where on the guide's axis the joint has its point says nothing of
// where the push acts.
TEST(LoadGains, OfAPushAlongAGuideOnTheSeatNone) {
  constexpr double kEnd = -0.1;  // [m]
  for (const double at : {-0.3, kEnd, 0.08}) {
    MechanismDefinition definition;
    definition.bodies = {bar(Vector3d::Zero())};
    definition.joints = {joint(JointType::kPrismatic, kGround, 0, at)};
    for (JointFrame* frame :
         {&definition.joints[0].frame_a, &definition.joints[0].frame_b}) {
      frame->R_LJ.col(0) = Vector3d::UnitY();
      frame->R_LJ.col(1) = Vector3d::UnitZ();
      frame->R_LJ.col(2) = Vector3d::UnitX();
    }
    Instant instant;
    instant.bodies.resize(1);
    instant.joints.resize(1);
    instant.joints[0].p_WJ = at * Vector3d::UnitX();
    const auto gain = [&](LoadPlace::Kind kind) {
      return load_gains(Neighbours(definition, 0), instant,
                        {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()},
                         {kind, 0, kEnd * Vector3d::UnitX()}})
          .norm();
    };
    MechanismDefinition without = definition;
    DriveDefinition drive;
    drive.joint = 0;
    definition.drives = {drive};
    instant.drives = {{.effort = -kForce}};
    EXPECT_LT(gain(LoadPlace::Kind::kDrive), kRoundOff * kForce) << at;

    definition = without;
    instant.drives.clear();
    LineElement push;
    push.line = {.kind = ElementLine::Kind::kJoint, .joint = 0};
    definition.elements = {push};
    ElementState state;
    state.actions[0] = {.body = kGround,
                        .p_W = at * Vector3d::UnitX(),
                        .f_W = kForce * Vector3d::UnitX()};
    state.actions[1] = {.body = 0,
                        .p_W = at * Vector3d::UnitX(),
                        .f_W = -kForce * Vector3d::UnitX()};
    instant.elements = {state};
    EXPECT_LT(gain(LoadPlace::Kind::kElement), kRoundOff * kForce) << at;
  }
}

// A force on a face: a point behind the face, along the force, does not hold
// the part up; one ahead of it, of a fixture, pushes it over.
TEST(LoadGains, PointBehindTheFaceHoldsNothing) {
  MechanismDefinition definition;
  definition.bodies = {bar(Vector3d::Zero())};
  definition.elements = {ConstantForce{}};
  Instant instant;
  instant.bodies.resize(1);
  const auto turned = [&](double ahead) {  // of a face that is pressed
    ElementState state;
    state.actions[1] = {.body = 0,
                        .p_W = ahead * Vector3d::UnitX(),
                        .f_W = -kForce * Vector3d::UnitX()};
    instant.elements = {state};
    const MatrixXd gain =
        load_gains(Neighbours(definition, 0), instant,
                   {{LoadPlace::Kind::kElement, 0, Vector3d::Zero()}});
    return gain(5, 5);
  };
  EXPECT_NEAR(turned(0.0), 0.0, kRoundOff);
  EXPECT_NEAR(turned(-0.2), 0.0, kRoundOff);
  EXPECT_NEAR(turned(0.2), 0.2 * kForce, kRoundOff * kForce);
}

/// On a pin of the ground, where a torque changes by 20 N m over 0.2 rad.
double gain_by_table(double sign) {
  MechanismDefinition m;
  m.bodies = {bar(Vector3d::Zero())};
  m.joints = {joint(JointType::kRevolute, kGround, 0, 0.0)};
  LineElement table;
  table.line.joint = 0;
  table.law = TableLaw{.efforts = {-10.0 * sign, 10.0 * sign},
                       .positions = {-0.1, 0.1}};
  m.elements = {table};
  Instant instant;
  instant.bodies.resize(1);
  instant.joints.resize(1);
  instant.elements.resize(1);
  instant.elements[0].actions[1].body = 0;
  return load_gains(Neighbours(m, 0), instant,
                    {{LoadPlace::Kind::kJoint, 0, Vector3d::Zero()}})(5, 5);
}

// One that falls is a spring, which is not among the loads.
TEST(LoadGains, TorqueThatRisesPushesOn) {
  EXPECT_NEAR(gain_by_table(1.0), 100.0, 1e-9);
  EXPECT_EQ(gain_by_table(-1.0), 0.0);
}

}  // namespace
}  // namespace clevis::mechanism
