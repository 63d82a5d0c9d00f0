// Joints whose frames lie askew to the axes in which a planar mechanism is
// solved: their compliance shares, and their components are told, along their
// own.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPull = 1000.0, kLength = 0.2;

JointDefinition weld(const char* name, double x, const Matrix3d& axes,
                     const Vector3d& compliance) {
  JointDefinition joint;
  joint.name = joint.place = name;
  joint.type = JointType::kWeld;
  joint.body_b = 0;
  joint.frame_a.p_LJ = joint.frame_b.p_LJ = {x, 0.0, 0.0};
  joint.frame_a.R_LJ = joint.frame_b.R_LJ = axes;
  joint.compliance = JointCompliance{compliance, Vector3d::Constant(1e-3)};
  return joint;
}

Matrix3d about(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

/// A bar along x between a weld of soft x and stiff y and z in its own frame,
/// and an even one; pulled along it at the first.
MechanismDefinition bar(const Matrix3d& axes, SpaceDimension dimension) {
  MechanismDefinition m;
  m.dimension = dimension;
  BodyDefinition body;
  body.name = body.place = "bar";
  body.mass_properties = {1.0, Vector3d(0.1, 0.0, 0.0),
                          1e-3 * Matrix3d::Identity()};
  m.bodies = {body};
  m.joints = {
      weld("left", 0.0, axes, {1e-5, 1e-7, 1e-7}),
      weld("right", kLength, Matrix3d::Identity(), Vector3d::Constant(1e-5))};
  ConstantForce pull;
  pull.name = "pull";
  pull.point.body = 0;
  pull.f_W = {kPull, 0.0, 0.0};
  m.elements = {pull};
  return m;
}

Instant instant(const MechanismDefinition& m) {
  return simulate(m, {.duration = 1.0, .instants = 2}).instants[0];
}

// z out of the plane, and x or y instead of it, as the user may turn a weld.
TEST(AskewJoints, CompliancesShareInThePlaneAsInSpace) {
  const double turn = std::numbers::pi / 4.0;
  for (const Matrix3d& axes :
       {about(Vector3d::UnitZ(), turn),
        Matrix3d(about(Vector3d::UnitZ(), turn) *
                 about(Vector3d::UnitX(), 0.5 * std::numbers::pi)),
        Matrix3d(about(Vector3d::UnitZ(), 0.3) *
                 about(Vector3d::UnitY(), 0.5 * std::numbers::pi))}) {
    const Instant planar = instant(bar(axes, SpaceDimension::kPlanar));
    const Instant spatial = instant(bar(axes, SpaceDimension::kSpatial));
    for (const std::size_t j : {0u, 1u}) {
      const JointReaction &one = planar.joints[j], &other = spatial.joints[j];
      EXPECT_LT((one.f_W - other.f_W).norm(), 1e-6 * kPull);
      EXPECT_LT((one.R_WJ - other.R_WJ).norm(), 1e-12);
      EXPECT_LT((one.components() - other.components()).norm(), 1e-6 * kPull);
      for (std::size_t k = 0; k < 6; ++k) {
        if (std::abs(other.components()[static_cast<Eigen::Index>(k)]) <
            1e-3 * kPull) {
          continue;
        }
        EXPECT_EQ(one.unique_components[k], other.unique_components[k]);
        EXPECT_NEAR(one.spread[k], other.spread[k], 1e-6 * kPull);
      }
    }
    EXPECT_LT((planar.joints[0].R_WJ - axes).norm(), 1e-12);
  }
  // Askew the pull pushes aside: it does not along the soft axis.
  const auto aside = [&](double angle) {
    return std::abs(
        instant(bar(about(Vector3d::UnitZ(), angle), SpaceDimension::kPlanar))
            .joints[1]
            .f_W.y());
  };
  EXPECT_GT(aside(turn), 0.05 * kPull);
  EXPECT_LT(aside(0.0), 1e-9 * kPull);
}

// Coupled with what goes across, it is solved in space.
TEST(AskewJoints, ComplianceAcrossThePlane) {
  const Matrix3d axes = about(Vector3d::UnitY(), 0.5);
  const Instant found = instant(bar(axes, SpaceDimension::kAuto));
  const Instant spatial = instant(bar(axes, SpaceDimension::kSpatial));
  EXPECT_LT((found.joints[1].f_W - spatial.joints[1].f_W).norm(), 1e-9 * kPull);
  EXPECT_GT(std::abs(found.joints[1].f_W.z()), 0.01 * kPull);
  EXPECT_THROW(instant(bar(axes, SpaceDimension::kPlanar)), Error);
}

}  // namespace
}  // namespace clevis::mechanism
