// Joints that stand a little off the axes of their bores.
#include "loads/parts/axis_loads.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "loads/history/balance.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.1, kOffset = 8e-6, kForce = 1000.0;

/// A rod without mass worth naming, pulled along the line of its joints A and
/// B; the bores stand where a test puts them.
struct Rod {
  mechanism::MechanismDefinition definition;
  part::PartDefinition part;
  std::vector<GroupGeometry> groups;
  part::MassProperties mass;
  LoadHistory history;

  Rod(const Vector3d& bore_A, const Vector3d& bore_B, double length = kLength) {
    definition.bodies.resize(1);
    definition.bodies[0].name = "rod";
    part.name = "rod";
    mass.mass = 0.1;
    mass.p_LCm = {0.5 * kLength, 0.0, 0.0};
    mass.inertia_LCm = Vector3d(1e-6, 1e-4, 1e-4).asDiagonal();
    add_joint("A", Vector3d::Zero(), bore_A);
    add_joint("B", {length, 0.0, 0.0}, bore_B);
    InstantLoad pull;
    const Vector3d f(kForce, 0.0, 0.0);
    pull.wrenches = {about(-f, Vector3d::Zero(), Vector3d::Zero(), bore_A),
                     about(f, Vector3d::Zero(), {length, 0.0, 0.0}, bore_B)};
    history.instants = {pull};
    for (const auto& seat : seats()) history.seats.push_back(seat.seat);
  }

  void add_joint(const std::string& name, const Vector3d& at,
                 const Vector3d& bore) {
    mechanism::JointDefinition joint;
    joint.name = name;
    joint.type = mechanism::JointType::kRevolute;
    joint.body_b = 0;
    joint.frame_b.p_LJ = at;
    definition.joints.push_back(joint);
    GroupGeometry group;
    group.name = "bore_" + name;
    group.is_cylinder = true;
    group.cylinder = {.p_LC = bore,
                      .axis_L = Vector3d::UnitZ(),
                      .radius = 5e-3,
                      .length = 8e-3};
    group.area = 2.0 * std::numbers::pi * 5e-3 * 8e-3;
    groups.push_back(group);
  }

  std::vector<JointSeat> seats() const {
    std::vector<JointSeat> result;
    for (std::size_t i = 0; i < definition.joints.size(); ++i) {
      const auto& joint = definition.joints[i];
      result.push_back({{i, &joint, &joint.frame_b, 1.0},
                        {.name = joint.name,
                         .group = "bore_" + joint.name,
                         .kind = SeatKind::kBearing,
                         .p_LS = groups[i].cylinder.p_LC}});
    }
    return result;
  }

  void act() {
    const SeatContext context{definition, 0, part, groups, 0.1};
    act_on_axes(context, seats(), mass, history);
  }
  const Wrench& wrench(std::size_t seat) const {
    return history.instants[0].wrenches[seat];
  }
  double rest() const {
    const Wrench left = residual(history, history.instants[0], mass);
    return left.force.norm() + left.moment.norm() / kLength;
  }
};

// Two pins without friction can only pull along the line between them.
TEST(AxisLoads, ARodIsPulledAlongTheLineOfItsBores) {
  for (const Vector3d& offset :
       {Vector3d(0.0, kOffset, 0.0), Vector3d(kOffset, -kOffset, 0.0)}) {
    const Vector3d bore_B = Vector3d(kLength, 0.0, 0.0) + offset;
    Rod rod(Vector3d::Zero(), bore_B);
    EXPECT_LT(rod.rest(), 1e-12 * kForce);
    rod.act();
    const Vector3d along = kForce * bore_B / kLength;
    // Beside the second order: the length of the line is no matter of balance.
    const double second = kForce * 4.0 * std::pow(kOffset / kLength, 2);
    EXPECT_LT((rod.wrench(1).force - along).cross(bore_B).norm(),
              second * kLength);
    EXPECT_LT((rod.wrench(0).force + rod.wrench(1).force).norm(), second);
    EXPECT_LT(rod.wrench(0).moment.norm(), 1e-12 * kForce * kLength);
    EXPECT_LT(rod.wrench(1).moment.norm(), 1e-12 * kForce * kLength);
    EXPECT_LT(rod.rest(), 1e-12 * kForce);
    ASSERT_EQ(rod.history.notes.size(), 2u);
    EXPECT_NE(rod.history.notes[0].find("joint B stands"), std::string::npos);
  }
}

TEST(AxisLoads, APlaceAlongTheAxisKeepsItsMoment) {
  const Vector3d bore_B(kLength, kOffset, 2e-3);
  Rod rod(Vector3d::Zero(), bore_B);
  rod.act();
  // 2 mm below the middle of the bore: a moment about y, as pins can carry.
  EXPECT_NEAR(rod.wrench(1).moment.y(), -2e-3 * kForce, 1e-3 * 2e-3 * kForce);
  EXPECT_LT(rod.rest(), 1e-12 * kForce);
}

// On one axis the pins have no lever: a couple of them would be as large as
// the force itself.
TEST(AxisLoads, InertiaTakesUpWhatPinsOnOneAxisCannot) {
  Rod rod(Vector3d::Zero(), {0.0, kOffset, 0.02}, 0.0);
  const double force = rod.wrench(1).force.norm();
  rod.act();
  EXPECT_EQ(rod.wrench(1).force.norm(), force);
  EXPECT_NE(rod.history.instants[0].rigid.alpha.z(), 0.0);
  EXPECT_LT(rod.rest(), 1e-12 * kForce);
}

TEST(AxisLoads, NothingHappensToJointsOnTheirAxes) {
  Rod rod(Vector3d::Zero(), {kLength, 1e-8, 0.0});
  const Wrench before = rod.wrench(1);
  rod.act();
  EXPECT_EQ(rod.wrench(1).force, before.force);
  EXPECT_EQ(rod.wrench(1).moment, before.moment);
  EXPECT_TRUE(rod.history.notes.empty());
}

}  // namespace
}  // namespace clevis::loads
