#include "loads/parts/case_loads.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/parts/part_loads.h"

namespace clevis::loads {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

GroupGeometry bore(const std::string& name, const Vector3d& at) {
  const part::Bore c{.p_LC = at,
                     .axis_L = Vector3d::UnitZ(),
                     .radius = 7.5e-3,
                     .length = 5e-3};
  return {.name = name,
          .is_cylinder = true,
          .cylinder = c,
          .centroid = at,
          .area = 2.0 * std::numbers::pi * c.radius * c.length};
}

// A box 20 × 10 × 5 mm from the origin on: two of its faces.
GroupGeometry x_face(const std::string& name, double x, double sign) {
  const double area = 10e-3 * 5e-3;
  const Vector3d c(x, 5e-3, 2.5e-3);
  const Vector3d n(sign, 0.0, 0.0);
  GroupGeometry face;
  face.name = name;
  face.centroid = c;
  face.area = area;
  face.area_vector = area * n;
  face.area_moment = c.cross(area * n);
  return face;
}

std::vector<GroupGeometry> groups() {
  return {bore("bore_A", Vector3d::Zero()), bore("bore_B", {0.14, 0.0, 0.0}),
          x_face("left", 0.0, -1.0), x_face("right", 20e-3, 1.0)};
}

part::MassProperties box_mass() {
  const double m = 7850.0 * 20e-3 * 10e-3 * 5e-3;
  return {
      .mass = m,
      .p_LCm = {10e-3, 5e-3, 2.5e-3},
      .inertia_LCm = m / 12.0 * Vector3d(125e-6, 425e-6, 500e-6).asDiagonal()};
}

part::PartDefinition part_definition() {
  part::PartDefinition part;
  part.name = "P";
  part.place = "scene.toml:3:1";
  return part;
}

LoadHistory loads_of(const part::LoadCaseDefinition& load_case) {
  return case_loads(part_definition(), load_case, groups(), box_mass());
}

std::string code_of(const part::LoadCaseDefinition& load_case) {
  try {
    loads_of(load_case);
  } catch (const Error& error) {
    return error.code();
  }
  return "none";
}

part::LoadCaseDefinition pulled(double force_A, double force_B) {
  part::LoadCaseDefinition c;
  c.name = "pull";
  c.pins["bore_A"] = Vector3d(force_A, 0.0, 0.0);
  c.pins["bore_B"] = Vector3d(force_B, 0.0, 0.0);
  return c;
}

TEST(CaseLoads, PinsBecomeBearingSeatsOnTheirAxes) {
  const LoadHistory history = loads_of(pulled(-1000.0, 1000.0));
  ASSERT_EQ(history.seats.size(), 2u);
  EXPECT_EQ(history.seats[1].kind, SeatKind::kBearing);
  EXPECT_EQ(history.seats[1].p_LS, Vector3d(0.14, 0.0, 0.0));
  EXPECT_EQ(history.instants[0].wrenches[1].force, Vector3d(1000.0, 0.0, 0.0));
  EXPECT_EQ(history.instants[0].label, "pull");
}

TEST(CaseLoads, UnbalancedFreePartIsRefusedWithItsResidual) {
  try {
    loads_of(pulled(-1000.0, 1010.0));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "L001");
    EXPECT_NE(error.problem().find("(10, 0, 0) N"), std::string::npos)
        << error.problem();
    EXPECT_NE(error.problem().find("0.498 %"), std::string::npos)
        << error.problem();
  }
  // a thousandth of all forces' magnitudes
  EXPECT_EQ(code_of(pulled(-1000.0, 1002.1)), "L001");
  EXPECT_EQ(code_of(pulled(-1000.0, 1001.9)), "none");
}

// Typed to six digits. The rest accelerates the part: F = m a at the centre of
// mass, and about it M = I α.
TEST(CaseLoads, InertiaTakesUpASmallRest) {
  part::LoadCaseDefinition c;
  c.name = "typed";
  c.pins["bore_A"] = Vector3d(-70.7107, 70.7107, 0.0);
  c.pins["bore_B"] = Vector3d(70.7108, -70.7106, 0.0);
  // no couple but a small one
  c.pins["bore_A"].y() -= 70.7107;
  c.pins["bore_B"].y() += 70.7107;
  const LoadHistory history = loads_of(c);
  const InstantLoad& load = history.instants[0];
  const Vector3d rest(1e-4, 1e-4, 0.0);
  const Vector3d moment(0.0, 0.0, 0.14 * 1e-4);  // about the origin, bore_A
  EXPECT_LT((load.relief.force - rest).norm(), 1e-12);
  EXPECT_LT((load.relief.moment - moment).norm(), 1e-12);
  const part::MassProperties mass = box_mass();
  const Vector3d& com = mass.p_LCm;
  const double alpha = (moment - com.cross(rest)).z() / mass.inertia_LCm(2, 2);
  EXPECT_NEAR(load.rigid.alpha.z(), alpha, 1e-9 * std::abs(alpha));
  const Vector3d at_com = load.rigid.acceleration + load.rigid.alpha.cross(com);
  EXPECT_LT((at_com - rest / mass.mass).norm(), 1e-9 * at_com.norm());
  EXPECT_LT(residual(history, load, mass).force.norm(), 1e-12);
  EXPECT_LT(residual(history, load, mass).moment.norm(), 1e-13);
}

TEST(CaseLoads, RestThatIsRoundOffIsLeftAlone) {
  const LoadHistory history = loads_of(pulled(-1000.0, 1000.0 + 1e-7));
  EXPECT_EQ(history.instants[0].relief.force, Vector3d::Zero());
  EXPECT_EQ(history.instants[0].rigid.acceleration, Vector3d::Zero());
}

TEST(CaseLoads, CoupleWithoutForceIsRefusedToo) {
  part::LoadCaseDefinition c;
  c.name = "couple";
  c.pins["bore_A"] = Vector3d(0.0, -10.0, 0.0);
  c.pins["bore_B"] = Vector3d(0.0, 10.0, 0.0);
  EXPECT_EQ(code_of(c), "L001");
}

TEST(CaseLoads, SupportsTakeWhatIsLeft) {
  part::LoadCaseDefinition c = pulled(0.0, 1000.0);
  c.fixed["left"] = {true, true, true};
  EXPECT_EQ(code_of(c), "none");
  c.fixed["nowhere"] = {true, true, true};
  EXPECT_EQ(code_of(c), "M003");
}

TEST(CaseLoads, NotANumberIsRefused) {
  EXPECT_EQ(code_of(pulled(std::nan(""), 1000.0)), "L001");
}

// Pressure on opposite faces cancels; p = σ_0 on one face alone is a bar that
// is accelerated by σ_0/(ρ L).
TEST(CaseLoads, PressurePushesAgainstTheNormal) {
  part::LoadCaseDefinition c;
  c.name = "squeezed";
  c.pressure = {{"left", 2e6}, {"right", 2e6}};
  EXPECT_EQ(code_of(c), "none");
  c.pressure.erase("right");
  EXPECT_EQ(code_of(c), "L001");
  c.acceleration.x() = 2e6 / (7850.0 * 20e-3);
  EXPECT_EQ(code_of(c), "none");
  const LoadHistory history = loads_of(c);
  ASSERT_EQ(history.instants[0].surface_loads.size(), 1u);
  EXPECT_NEAR(history.instants[0].surface_loads[0].resultant.force.x(), 100.0,
              1e-9);
}

TEST(CaseLoads, PressureAndTractionOnOneGroupAddUp) {
  part::LoadCaseDefinition c;
  c.name = "both";
  c.pressure = {{"right", 1e6}};
  c.traction = {{"right", Vector3d(1e6, 0.0, 0.0)}};
  EXPECT_EQ(code_of(c), "none");
  EXPECT_EQ(loads_of(c).instants[0].surface_loads.size(), 1u);
}

TEST(CaseLoads, TractionActsAtTheCentroid) {
  part::LoadCaseDefinition c;
  c.name = "sheared";
  c.traction = {{"right", Vector3d(0.0, 1e6, 0.0)}};
  c.fixed["left"] = {true, true, true};
  const SurfaceLoad load = loads_of(c).instants[0].surface_loads[0];
  EXPECT_NEAR(load.resultant.force.y(), 50.0, 1e-9);
  EXPECT_NEAR(load.resultant.moment.z(), 50.0 * 20e-3, 1e-9);
  EXPECT_NEAR(load.resultant.moment.x(), -50.0 * 2.5e-3, 1e-9);
}

TEST(CaseLoads, PinNeedsACylinder) {
  part::LoadCaseDefinition c;
  c.name = "flat";
  c.pins["left"] = Vector3d(1.0, 0.0, 0.0);
  EXPECT_EQ(code_of(c), "L002");
}

// A spinning body held by nothing: the centre's acceleration must be given,
// and the gyroscopic moment of a spin off the principal axes is a moment.
TEST(CaseLoads, SpinNeedsTheForceAtTheCentre) {
  part::LoadCaseDefinition c;
  c.name = "spin";
  const Vector3d omega(0.0, 0.0, 100.0);
  c.angular_velocity = omega;
  EXPECT_EQ(code_of(c), "L001");
  c.acceleration = -omega.cross(omega.cross(box_mass().p_LCm));
  EXPECT_EQ(code_of(c), "none");
  const Vector3d tilted(0.0, 50.0, 100.0);
  c.angular_velocity = tilted;
  c.acceleration = -tilted.cross(tilted.cross(box_mass().p_LCm));
  // Euler: I α + ω × I ω = 0 lets the free body tumble. The moment is less than
  // a thousandth of what pulls the box apart: inertia takes it up, just so.
  const Matrix3d I = box_mass().inertia_LCm;
  const Vector3d alpha = -I.inverse() * tilted.cross(Vector3d(I * tilted));
  const Vector3d relieved = loads_of(c).instants[0].rigid.alpha;
  EXPECT_LT((relieved - alpha).norm(), 1e-9 * alpha.norm());
  c.angular_acceleration = alpha;
  c.acceleration -= c.angular_acceleration.cross(box_mass().p_LCm);
  EXPECT_EQ(code_of(c), "none");
}

}  // namespace
}  // namespace clevis::loads
