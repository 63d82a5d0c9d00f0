#include "loads/parts/part_loads.h"

#include <array>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"

namespace clevis::loads {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanism::JointType;

// Body "P" made of point masses hangs between joint A (P is body b), joint B
// (P is body a) and a driven slide S (P is body b), in a general motion. The
// reaction at B is what Newton's law, summed over the point masses in W,
// leaves; nothing of the code's own balance is used.
struct Particle {
  double mass;
  Vector3d p_L;
};
constexpr int kParticles = 5;
const std::array<Particle, kParticles> kMasses{{{0.3, {0.00, 0.01, 0.00}},
                                                {0.1, {0.05, -0.02, 0.01}},
                                                {0.2, {0.09, 0.03, -0.01}},
                                                {0.4, {0.14, 0.00, 0.02}},
                                                {0.2, {0.03, 0.05, 0.005}}}};

part::MassProperties mass_properties() {
  part::MassProperties m;
  for (const Particle& p : kMasses) {
    m.mass += p.mass;
    m.p_LCm += p.mass * p.p_L;
  }
  m.p_LCm /= m.mass;
  for (const Particle& p : kMasses) {
    const Vector3d r = p.p_L - m.p_LCm;
    m.inertia_LCm +=
        p.mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
  return m;
}

GroupGeometry cylinder(const std::string& name, const Vector3d& at,
                       const Vector3d& axis) {
  const part::Bore c{
      .p_LC = at, .axis_L = axis, .radius = 5e-3, .length = 8e-3};
  return {.name = name,
          .is_cylinder = true,
          .cylinder = c,
          .centroid = at,
          .area = 2.0 * std::numbers::pi * c.radius * c.length};
}

GroupGeometry cap() {
  GroupGeometry cap;
  cap.name = "cap";
  cap.centroid = {0.06, 0.041, 0.0};
  cap.area = 2e-4;
  cap.area_vector = {-2e-4, 0.0, 0.0};
  return cap;
}

struct LinkInMotion {
  mechanism::MechanismDefinition definition;
  mechanism::Motion motion;
  part::PartDefinition part;
  std::vector<GroupGeometry> groups;
  part::MassProperties mass;

  LoadHistory loads() const {
    return part_loads(definition, motion, 0, part, groups, mass);
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

mechanism::JointDefinition joint(const std::string& name, JointType type,
                                 int body_a, int body_b) {
  mechanism::JointDefinition joint;
  joint.name = name;
  joint.type = type;
  joint.body_a = body_a;
  joint.body_b = body_b;
  return joint;
}

Matrix3d z_to_x() {
  return Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3d::UnitY())
      .toRotationMatrix();
}

const Vector3d kGravity(0.0, -9.81, 0.0);
const Vector3d kA(0.0, 0.0, 0.0), kB(0.14, 0.0, 0.0), kS(0.05, 0.04, 0.0);
// The slide's joint lies on the axis of its cylinder, away from its middle.
const Vector3d kSlideJoint(0.03, 0.04, 0.0);

void define_body(LinkInMotion& s) {
  auto& d = s.definition;
  d.gravity_W = kGravity;
  d.bodies.resize(2);
  d.joints = {joint("A", JointType::kRevolute, -1, 0),
              joint("B", JointType::kRevolute, 0, 1),
              joint("S", JointType::kPrismatic, 1, 0)};
  d.joints[0].frame_b.p_LJ = kA;
  d.joints[1].frame_a.p_LJ = kB;
  d.joints[2].frame_b = {kSlideJoint, z_to_x()};
  d.drives.resize(1);
  d.drives[0].joint = 2;
  s.part.name = "P";
  s.part.seats = {{"A", "bore_A"}, {"B", "bore_B"}, {"S", "round_S"}};
  s.part.seats[2].slide.length = 8e-3;  // all of it
  s.part.drive_seats = {{"S", "cap", {"wall"}}};
  s.groups = {cylinder("bore_A", {0.0, 0.0, 1e-3}, Vector3d::UnitZ()),
              cylinder("bore_B", {0.14, 0.0, -1e-3}, -Vector3d::UnitZ()),
              cylinder("round_S", kS, Vector3d::UnitX()),
              cylinder("wall", {0.07, 0.04, 0.0}, Vector3d::UnitX()), cap()};
  s.mass = mass_properties();
}

mechanism::Pose general_pose() {
  return {.p_WL = {0.3, -0.2, 0.1},
          .R_WL = Eigen::AngleAxisd(0.7, Vector3d(0.2, -0.4, 1.0).normalized())
                      .toRotationMatrix()};
}

void move_body(LinkInMotion& s) {
  mechanism::Instant instant;
  instant.t = 0.25;
  mechanism::BodyState body{.pose = general_pose(),
                            .w_WL = {3.0, -2.0, 9.0},
                            .a_WLo = {4.0, 25.0, -7.0},
                            .alpha_WL = {-30.0, 12.0, 80.0}};
  const mechanism::Pose& pose = body.pose;
  const auto world = [&](const Vector3d& p_L) -> Vector3d {
    return pose.p_WL + pose.R_WL * p_L;
  };
  instant.bodies = {body, {}};
  instant.joints.resize(3);
  instant.joints[0] = {world(kA), {120.0, -40.0, 15.0}, {0.3, 0.1, 0.0}};
  instant.joints[2] = {
      world(kSlideJoint), {10.0, 60.0, -25.0}, {1.0, -2.0, 0.5}};
  instant.drives = {{.effort = 800.0, .axis_W = pose.R_WL * Vector3d::UnitX()}};
  // Newton: what B must give, about the world's origin.
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  for (const Particle& p : kMasses) {
    const Vector3d r = pose.R_WL * p.p_L;
    const Vector3d a = body.a_WLo + body.alpha_WL.cross(r) +
                       body.w_WL.cross(body.w_WL.cross(r)) - kGravity;
    force += p.mass * a;
    moment += p.mass * (pose.p_WL + r).cross(a);
  }
  const auto take = [&](const Vector3d& at, const Vector3d& f,
                        const Vector3d& t) {
    force -= f;
    moment -= t + at.cross(f);
  };
  take(world(kA), instant.joints[0].f_W, instant.joints[0].t_W);
  take(world(kSlideJoint), instant.joints[2].f_W, instant.joints[2].t_W);
  take(world(kSlideJoint), 800.0 * instant.drives[0].axis_W, Vector3d::Zero());
  // P is body a of B: the reaction recorded is the one on Q.
  instant.joints[1] = {world(kB), -force, -(moment - world(kB).cross(force))};
  s.motion.instants = {instant};
}

LinkInMotion general_link() {
  LinkInMotion s;
  define_body(s);
  move_body(s);
  return s;
}

TEST(PartLoads, GeneralMotionIsInBalance) {
  const LinkInMotion s = general_link();
  const LoadHistory history = s.loads();
  ASSERT_EQ(history.seats.size(), 4u);
  const Wrench left = residual(history, history.instants[0], s.mass);
  EXPECT_LT(left.force.norm(), 1e-12 * 1000.0);
  EXPECT_LT(left.moment.norm(), 1e-12 * 1000.0);
  EXPECT_EQ(history.instants[0].label, "t = 0.25 s");
}

TEST(PartLoads, AnyForceOffByOnePartIn1e7IsRefused) {
  for (const std::size_t joint : {0u, 1u, 2u}) {
    LinkInMotion s = general_link();
    s.motion.instants[0].joints[joint].f_W *= 1.0 + 1e-6;
    EXPECT_EQ(s.code(), "L001") << joint;
  }
  LinkInMotion s = general_link();
  s.motion.instants[0].drives[0].effort *= -1.0;
  EXPECT_EQ(s.code(), "L001");
}

TEST(PartLoads, ReactionActsOnBodyBAndItsOppositeOnBodyA) {
  const LinkInMotion s = general_link();
  const auto& instant = s.motion.instants[0];
  const LoadHistory history = s.loads();
  const Matrix3d R_LW = general_pose().R_WL.transpose();
  const auto& w = history.instants[0].wrenches;
  EXPECT_LT((w[0].force - R_LW * instant.joints[0].f_W).norm(), 1e-9);
  EXPECT_LT((w[1].force + R_LW * instant.joints[1].f_W).norm(), 1e-9);
  EXPECT_LT((w[3].force - Vector3d(800.0, 0.0, 0.0)).norm(), 1e-9);
}

// bore_A's middle is 1 mm above the joint: the moment about it changes by
// -(1 mm ẑ) × f.
TEST(PartLoads, MomentsAreAboutTheMiddleOfTheSeat) {
  const LinkInMotion s = general_link();
  const LoadHistory history = s.loads();
  EXPECT_EQ(history.seats[0].p_LS, Vector3d(0.0, 0.0, 1e-3));
  const Matrix3d R_LW = general_pose().R_WL.transpose();
  const auto& reaction = s.motion.instants[0].joints[0];
  const Vector3d f = R_LW * reaction.f_W;
  const Vector3d wanted =
      R_LW * reaction.t_W + Vector3d(1e-3 * f.y(), -1e-3 * f.x(), 0.0);
  EXPECT_LT((history.instants[0].wrenches[0].moment - wanted).norm(), 1e-12);
  // The drive's axis passes 1 mm below the cap's centroid.
  EXPECT_NEAR(history.instants[0].wrenches[3].moment.z(), 800.0 * 1e-3, 1e-10);
}

TEST(PartLoads, PushingDrivePressurizesPullingDoesNot) {
  LinkInMotion s = general_link();
  const LoadHistory pushing = s.loads();
  ASSERT_EQ(pushing.instants[0].surface_loads.size(), 1u);
  EXPECT_DOUBLE_EQ(pushing.instants[0].surface_loads[0].pressure, 800.0 / 2e-4);
  // Turn the drive round and let joint B take the difference.
  auto& instant = s.motion.instants[0];
  const Vector3d change = 1600.0 * instant.drives[0].axis_W;
  const mechanism::Pose pose = general_pose();
  const Vector3d p_WS = pose.p_WL + pose.R_WL * kSlideJoint;
  instant.drives[0].effort = -800.0;
  instant.joints[1].f_W -= change;
  instant.joints[1].t_W -= (p_WS - instant.joints[1].p_WJ).cross(change);
  const LoadHistory pulling = s.loads();
  EXPECT_EQ(pulling.instants[0].surface_loads[0].pressure, 0.0);
}

TEST(PartLoads, InertiaIsExpressedInThePart) {
  const LinkInMotion s = general_link();
  const RigidAcceleration rigid = s.loads().instants[0].rigid;
  const auto& body = s.motion.instants[0].bodies[0];
  const Matrix3d R = general_pose().R_WL;
  EXPECT_LT((R * rigid.acceleration - (body.a_WLo - kGravity)).norm(), 1e-12);
  EXPECT_LT((R * rigid.alpha - body.alpha_WL).norm(), 1e-12);
  EXPECT_LT((R * rigid.omega - body.w_WL).norm(), 1e-12);
}

TEST(PartLoads, BoreThatMissesItsJointIsRefusedWithTheGap) {
  LinkInMotion s = general_link();
  s.groups[1].cylinder.p_LC.x() += 0.1e-3;
  try {
    s.loads();
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "L003");
    EXPECT_NE(error.problem().find("0.1 mm off"), std::string::npos)
        << error.problem();
  }
  s = general_link();  // a thousandth of 10 mm is allowed
  s.groups[1].cylinder.p_LC.x() += 10.1e-6;
  EXPECT_EQ(s.code(), "L003");
}

// The moment of the reaction at A about A's axis is what acts on its bore; the
// offset times the force does not.
TEST(PartLoads, ABoreALittleOffItsJointTakesTheForceOnItsAxis) {
  const LoadHistory before = general_link().loads();
  LinkInMotion s = general_link();
  s.groups[0].cylinder.p_LC.y() += 9e-6;
  const LoadHistory history = s.loads();
  const Wrench& was = before.instants[0].wrenches[0];
  const Wrench& is = history.instants[0].wrenches[0];
  EXPECT_NEAR(is.moment.z(), was.moment.z(), 1e-12);
  EXPECT_GT((is.force - was.force).norm(), 0.0);
  EXPECT_LT((is.force - was.force).norm(), 1e-3 * was.force.norm());
  const Wrench left = residual(history, history.instants[0], s.mass);
  EXPECT_LT(left.force.norm() + left.moment.norm(), 1e-9);
  EXPECT_EQ(history.notes.size(), before.notes.size() + 2);
}

TEST(PartLoads, CylinderMustBeParallelToItsJoint) {
  LinkInMotion s = general_link();
  s.groups[0].cylinder.axis_L = Vector3d(0.0, 1e-4, 1.0).normalized();
  EXPECT_EQ(s.code(), "L003");
  s = general_link();
  s.groups[2].cylinder.p_LC.y() += 0.01e-3;  // slide off its axis
  EXPECT_EQ(s.code(), "L003");
}

TEST(PartLoads, EverythingOnTheBodyNeedsASeat) {
  LinkInMotion s = general_link();
  s.part.seats.pop_back();
  EXPECT_EQ(s.code(), "L004");
  s = general_link();
  s.part.drive_seats.clear();
  EXPECT_EQ(s.code(), "L004");
  s = general_link();
  mechanism::ConstantForce wind;
  wind.name = "wind";
  wind.point.body = 0;
  s.definition.elements = {wind};
  EXPECT_EQ(s.code(), "L004");
  wind.point.body = 1;
  s.definition.elements = {wind};
  EXPECT_EQ(s.code(), "none");
}

TEST(PartLoads, GroupsMustExistAndFit) {
  LinkInMotion s = general_link();
  s.part.seats[0].group = "bore_X";
  EXPECT_EQ(s.code(), "M003");
  s = general_link();
  s.part.seats[0].group = "cap";  // a pin on a flat face
  EXPECT_EQ(s.code(), "L002");
  s = general_link();
  s.groups[3].area_vector = Vector3d(1e-5, 0.0, 0.0);  // wall not closed
  EXPECT_EQ(s.code(), "L002");
}

// Round-off of a motion is relative to its largest load: an instant that
// carries next to nothing is not refused for it.
TEST(PartLoads, NearlyUnloadedInstantIsMeasuredAgainstTheLargest) {
  LinkInMotion s = general_link();
  mechanism::Instant rest = s.motion.instants[0];
  for (auto& joint : rest.joints) {
    joint.f_W.setZero();
    joint.t_W.setZero();
  }
  rest.drives[0].effort = 0.0;
  rest.bodies[0].a_WLo = kGravity;
  rest.bodies[0].w_WL.setZero();
  rest.bodies[0].alpha_WL.setZero();
  rest.joints[0].f_W.x() = 1e-13;
  s.motion.instants.push_back(rest);
  EXPECT_EQ(s.code(), "none");
  s.motion.instants[1].joints[0].f_W.x() = 1e-9;
  EXPECT_EQ(s.code(), "none");
  s.motion.instants[1].joints[0].f_W.x() = 1e-5;
  EXPECT_EQ(s.code(), "L001");
}

}  // namespace
}  // namespace clevis::loads
