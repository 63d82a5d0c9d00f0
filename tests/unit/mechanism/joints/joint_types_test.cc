// Every joint type, every coordinate: rows against finite differences, motion
// against derivatives of positions, balance of every body.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/constraints/assembly.h"
#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/simulate.h"
#include "mechanism/structure/structure.h"
#include "support/landing_gear.h"
#include "support/newton_euler.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using namespace testing;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr JointType kTypes[] = {
    JointType::kRevolute,   JointType::kPrismatic, JointType::kCylindrical,
    JointType::kUniversal,  JointType::kSpherical, JointType::kPlanar,
    JointType::kScrew,      JointType::kWeld,      JointType::kDistance,
    JointType::kPointOnLine};

/// Numbers between −1 and 1, the same on every run.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double operator()() { return between_(engine_); }
  Vector3d vector() { return {(*this)(), (*this)(), (*this)()}; }
  Matrix3d rotation() {
    return Eigen::AngleAxisd(3.0 * (*this)(), vector().normalized())
        .toRotationMatrix();
  }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> between_{-1.0, 1.0};
};

BodyDefinition some_body(Dice& dice, const std::string& name) {
  BodyDefinition body;
  body.name = name;
  body.place = "body " + name;
  body.placement = {0.2 * dice.vector(), dice.rotation()};
  body.mass_properties = bar(1.0 + 0.5 * dice(), 0.03 * dice(), 0.02, 2e-3);
  return body;
}

/// Frames that coincide at the bodies' placements, turned on b by a little.
JointDefinition some_joint(Dice& dice, const MechanismDefinition& m,
                           JointType type, int a, int b) {
  JointDefinition joint;
  joint.name = "J" + std::to_string(m.joints.size());
  joint.type = type;
  joint.body_a = a;
  joint.body_b = b;
  joint.lead = 0.02;
  joint.length = 0.15;
  joint.place = "joint";
  const Vector3d p_W = 0.2 * dice.vector();
  const Matrix3d R_WJ = dice.rotation();
  const auto on = [&](int body) -> JointFrame {
    if (body == kGround) return {p_W, R_WJ};
    const Pose& X = m.bodies[static_cast<std::size_t>(body)].placement;
    return {X.R_WL.transpose() * (p_W - X.p_WL), X.R_WL.transpose() * R_WJ};
  };
  joint.frame_a = on(a);
  joint.frame_b = on(b);
  if (type == JointType::kDistance) joint.frame_b.p_LJ += 0.1 * dice.vector();
  return joint;
}

/// A drive of every coordinate of every joint of the type.
void drive_all(MechanismDefinition& m) {
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    // a screw's two coordinates are one
    const auto count = m.joints[j].type == JointType::kScrew
                           ? std::size_t{1}
                           : coordinates(m.joints[j].type).size();
    for (std::size_t k = 0; k < count; ++k) {
      DriveDefinition drive;
      drive.joint = static_cast<int>(j);
      drive.coordinate = static_cast<int>(k);
      drive.law = DriveLaw::kSine;
      drive.amplitude = drives_angle(m, drive) ? 0.6 : 0.05;
      drive.frequency = 0.7 + 0.3 * static_cast<double>(m.drives.size());
      m.drives.push_back(drive);
    }
  }
}

/// Ground, T, body, T, body; all driven.
MechanismDefinition chain(JointType type, unsigned seed) {
  Dice dice(seed);
  MechanismDefinition m;
  m.gravity_W = {1.0, -9.0, 3.0};
  m.dimension = SpaceDimension::kSpatial;
  m.bodies = {some_body(dice, "first"), some_body(dice, "second")};
  m.joints.push_back(some_joint(dice, m, type, kGround, 0));
  m.joints.push_back(some_joint(dice, m, type, 0, 1));
  drive_all(m);
  return m;
}

ConstraintSystem all_rows(const SolvingFrame& frame,
                          const MechanismDefinition& m) {
  return ConstraintSystem(frame, m.drives, Motions::kSpatial,
                          ConstraintSystem::Drives::kAll);
}

/// A closed configuration with all coordinates well away from zero.
Configuration closed_configuration(const ConstraintSystem& system,
                                   const SolvingFrame& frame, Dice& dice) {
  VectorXd targets(system.rows() - system.joint_rows());
  for (double& q : targets) q = 0.4 + 0.2 * dice();
  const Assembled found = assemble(system, frame.placement, targets, 1e-12);
  EXPECT_TRUE(found.closed);
  return found.x;
}

class EveryJoint : public ::testing::TestWithParam<JointType> {};

TEST_P(EveryJoint, JacobianIsTheDerivativeOfTheRows) {
  const MechanismDefinition m = chain(GetParam(), 7);
  const SolvingFrame frame(m);
  const ConstraintSystem system = all_rows(frame, m);
  Dice dice(3);
  const Configuration x = closed_configuration(system, frame, dice);
  const MatrixXd J = system.jacobian(system.place(x));
  const VectorXd none = VectorXd::Zero(system.rows() - system.joint_rows());
  constexpr double h = 1e-5;
  for (int column = 0; column < system.columns(); ++column) {
    const auto residual = [&](double step) {
      Configuration y = x;
      system.move(y, step * VectorXd::Unit(system.columns(), column));
      return system.residual(system.place(y), none);
    };
    const VectorXd difference = (residual(h) - residual(-h)) / (2.0 * h);
    EXPECT_LT((difference - J.col(column)).cwiseAbs().maxCoeff(), 1e-7)
        << name_of(GetParam()) << ", column " << column;
  }
}

// c(x(t)) of bodies that move with constant velocities, turned by move():
// c̈ is the bias where the joints' own rows stay closed. So the velocities
// must be those that the joints admit.
TEST_P(EveryJoint, BiasIsTheSecondDerivativeAlongAnAdmittedMotion) {
  const MechanismDefinition m = chain(GetParam(), 11);
  const SolvingFrame frame(m);
  const ConstraintSystem system = all_rows(frame, m);
  Dice dice(5);
  const Configuration x = closed_configuration(system, frame, dice);
  const MatrixXd J = system.jacobian(system.place(x));
  VectorXd rates = VectorXd::Zero(system.rows());
  for (int i = system.joint_rows(); i < system.rows(); ++i) rates[i] = dice();
  const VectorXd u = J.completeOrthogonalDecomposition().solve(rates);
  ASSERT_LT((J * u - rates).norm(), 1e-10);
  // accelerations that the bias asks for, so that rows and rates stay
  const VectorXd bias = system.bias(system.place(x), system.twists(u));
  const VectorXd a = J.completeOrthogonalDecomposition().solve(-bias);
  ASSERT_LT((J * a + bias).norm(), 1e-9);
  const VectorXd none = VectorXd::Zero(system.rows() - system.joint_rows());
  const auto residual = [&](double t) {
    Configuration y = x;
    system.move(y, t * u + 0.5 * t * t * a);
    return system.residual(system.place(y), none);
  };
  constexpr double h = 1e-3;
  const VectorXd second =
      (residual(h) - 2.0 * residual(0.0) + residual(-h)) / (h * h);
  // (h²/12 times the fourth derivative, and round-off over h²)
  EXPECT_LT(second.cwiseAbs().maxCoeff(), 2e-4 * (1.0 + bias.norm()))
      << name_of(GetParam());
}

TEST_P(EveryJoint, DrivenChainIsInBalance) {
  if (GetParam() == JointType::kDistance) return;  // leaves bodies loose
  const MechanismDefinition m = chain(GetParam(), 23);
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 41});
  for (const Instant& at : motion.instants) {
    EXPECT_LT(imbalance(m, at), 1e-11) << name_of(GetParam());
    EXPECT_LT(at.power_balance_error, 1e-12);
    for (std::size_t k = 0; k < m.drives.size(); ++k) {
      EXPECT_NEAR(at.drives[k].position,
                  drive_target(m.drives[k], at.t).position, 1e-15);
    }
  }
  const Structure s = analyse_structure(m);
  EXPECT_EQ(s.mobility, static_cast<int>(m.drives.size()));
  EXPECT_EQ(s.chebyshev, s.mobility);
  EXPECT_EQ(s.redundant, 0);
}

// Positions, velocities and accelerations belong together.
TEST_P(EveryJoint, AccelerationsAreDerivativesOfPositions) {
  if (GetParam() == JointType::kDistance || GetParam() == JointType::kWeld) {
    return;
  }
  const MechanismDefinition m = chain(GetParam(), 31);
  const Motion motion =
      simulate(m, {.duration = 0.4, .instants = 4001, .tolerance = 1e-13});
  constexpr double h = 1e-4;
  // truncation: h²/6 times n drives of 0.6 (2π f)⁴ at most, f the quickest
  const auto n = static_cast<double>(m.drives.size());
  const double quickest = 2.0 * std::numbers::pi * (0.7 + 0.3 * (n - 1.0));
  const double truncation =
      std::max(2.3e-4, h * h / 6.0 * n * 0.6 * std::pow(quickest, 4));
  constexpr double arm = 0.44;  // m, of points at which turns are seen
  for (std::size_t i = 1000; i + 1 < motion.instants.size(); i += 500) {
    for (std::size_t b = 0; b < m.bodies.size(); ++b) {
      const BodyState& before = motion.instants[i - 1].bodies[b];
      const BodyState& at = motion.instants[i].bodies[b];
      const BodyState& after = motion.instants[i + 1].bodies[b];
      const Vector3d v = (after.pose.p_WL - before.pose.p_WL) / (2.0 * h);
      EXPECT_LT((v - at.v_WLo).norm(), 1e-5);
      const Vector3d a = (after.v_WLo - before.v_WLo) / (2.0 * h);
      EXPECT_LT((a - at.a_WLo).norm(), arm * truncation);
      const Vector3d alpha = (after.w_WL - before.w_WL) / (2.0 * h);
      EXPECT_LT((alpha - at.alpha_WL).norm(), truncation)
          << name_of(GetParam());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Types, EveryJoint, ::testing::ValuesIn(kTypes),
                         [](const auto& type) {
                           return std::string(name_of(type.param));
                         });

/// A body turned by a driven joint; a second one that the coupling turns.
MechanismDefinition coupled(JointType type_1, JointType type_2, double ratio) {
  Dice dice(17);
  MechanismDefinition m;
  m.gravity_W = {0.0, -9.81, 1.0};
  m.dimension = SpaceDimension::kSpatial;
  m.bodies = {some_body(dice, "first"), some_body(dice, "second")};
  m.joints.push_back(some_joint(dice, m, type_1, kGround, 0));
  m.joints.push_back(some_joint(dice, m, type_2, kGround, 1));
  CouplingDefinition coupling;
  coupling.name = "mesh";
  coupling.joint_1 = 0;
  coupling.joint_2 = 1;
  coupling.ratio = ratio;
  m.couplings.push_back(coupling);
  DriveDefinition drive;
  drive.joint = 1;
  drive.law = DriveLaw::kQuintic;
  drive.to = 30.0;  // almost five turns
  drive.duration = 1.0;
  m.drives.push_back(drive);
  return m;
}

TEST(Coupling, GearTurnsWithItsRatioBeyondFullTurns) {
  // no whole ratio: the angles must count turns
  const MechanismDefinition m =
      coupled(JointType::kRevolute, JointType::kRevolute, -2.377);
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 31});
  for (const Instant& at : motion.instants) {
    EXPECT_LT(imbalance(m, at), 1e-11);
    EXPECT_LT(at.power_balance_error, 1e-12);
    const Matrix3d turn =
        at.bodies[0].pose.R_WL * m.bodies[0].placement.R_WL.transpose();
    const Vector3d axis = m.joints[0].frame_a.R_LJ.col(2);
    const Matrix3d expected =
        Eigen::AngleAxisd(-2.377 * at.drives[0].position, axis)
            .toRotationMatrix();
    EXPECT_LT((turn - expected).norm(), 1e-9);
    EXPECT_NEAR(at.bodies[0].w_WL.dot(axis), -2.377 * at.drives[0].rate, 1e-9);
  }
  const Structure s = analyse_structure(m);
  EXPECT_EQ(s.mobility, 1);
  EXPECT_EQ(s.chebyshev, 1);
}

TEST(Coupling, RackMovesByTheRadius) {
  const MechanismDefinition m =
      coupled(JointType::kPrismatic, JointType::kRevolute, 0.013);
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 31});
  for (const Instant& at : motion.instants) {
    EXPECT_LT(imbalance(m, at), 1e-11);
    const Vector3d axis = m.joints[0].frame_a.R_LJ.col(2);
    const Vector3d way = at.bodies[0].pose.p_WL - m.bodies[0].placement.p_WL;
    EXPECT_LT((way - 0.013 * at.drives[0].position * axis).norm(), 1e-11);
    // the pinion pays for the rack: effort ratio = radius
    EXPECT_NEAR(at.couplings[0].t_2_W.norm(),
                0.013 * at.couplings[0].f_1_W.norm(), 1e-12);
  }
}

// Two equal gears beside one another: each takes half, and is not unique.
TEST(Coupling, DuplicateTakesItsShare) {
  MechanismDefinition m =
      coupled(JointType::kRevolute, JointType::kRevolute, -2.0);
  const Motion single = simulate(m, {.duration = 1.0, .instants = 5});
  m.couplings.push_back(m.couplings[0]);
  for (const bool planar : {false, true}) {
    MechanismDefinition both = m;
    if (planar) {  // as many rows as columns, but not regular
      both.dimension = SpaceDimension::kPlanar;
      for (JointDefinition& joint : both.joints) {
        joint.frame_a.R_LJ.setIdentity();
        joint.frame_b.R_LJ.setIdentity();
      }
      for (BodyDefinition& body : both.bodies) {
        body.placement.R_WL.setIdentity();
      }
      both.drives.clear();
      both.elements = {
          testing::on_joint(0, TableLaw{.times = {0.0}, .efforts = {3.0}})};
    }
    const Motion motion = simulate(both, {.duration = 1.0, .instants = 5});
    for (std::size_t i = 0; i < motion.instants.size(); ++i) {
      const Instant& at = motion.instants[i];
      EXPECT_FALSE(at.couplings[0].unique);
      EXPECT_FALSE(at.couplings[1].unique);
      EXPECT_NEAR(at.couplings[0].effort, at.couplings[1].effort, 1e-9);
      EXPECT_GT(std::abs(at.couplings[0].effort), 1e-3);
      if (planar) continue;
      EXPECT_LT(imbalance(both, at), 1e-9);
      EXPECT_NEAR(at.couplings[0].effort,
                  0.5 * single.instants[i].couplings[0].effort, 1e-9);
    }
  }
}

TEST(Coupling, DriveOfBothWheelsIsRefused) {
  MechanismDefinition m =
      coupled(JointType::kRevolute, JointType::kRevolute, 2.0);
  DriveDefinition second = m.drives[0];
  second.joint = 0;
  m.drives.push_back(second);
  EXPECT_THROW(simulate(m, {.duration = 1.0}), Error);
}

TEST(Screw, CountsTurnsFromThePlacementOn) {
  MechanismDefinition m;
  Dice dice(2);
  m.bodies = {some_body(dice, "nut")};
  m.joints.push_back(some_joint(dice, m, JointType::kScrew, kGround, 0));
  m.joints[0].lead = -0.004;
  DriveDefinition drive;
  drive.coordinate = 1;  // distance
  drive.law = DriveLaw::kRamp;
  drive.from = 0.0;
  drive.to = 0.041;
  drive.duration = 1.0;
  m.drives = {drive};
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 11});
  const Vector3d axis = m.joints[0].frame_a.R_LJ.col(2);
  for (const Instant& at : motion.instants) {
    EXPECT_NEAR(at.bodies[0].w_WL.dot(axis),
                -2.0 * std::numbers::pi * 0.041 / 0.004, 1e-9);
    const Matrix3d turn =
        at.bodies[0].pose.R_WL * m.bodies[0].placement.R_WL.transpose();
    const double angle =
        -2.0 * std::numbers::pi * at.drives[0].position / 0.004;
    EXPECT_LT((turn - Eigen::AngleAxisd(angle, axis).toRotationMatrix()).norm(),
              1e-9);
  }
}

// A rod with ball ends and a cylindrical guide: 6 + … − 4 − 1.
TEST(Distance, RodHoldsACylindricalGuide) {
  Dice dice(41);
  MechanismDefinition m;
  m.gravity_W = {0.0, 0.0, -9.81};
  m.bodies = {some_body(dice, "slider")};
  m.joints.push_back(some_joint(dice, m, JointType::kCylindrical, kGround, 0));
  JointDefinition rod = some_joint(dice, m, JointType::kDistance, kGround, 0);
  rod.length = 0.3;
  m.joints.push_back(rod);
  DriveDefinition drive;
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.5;
  drive.frequency = 2.0;
  m.drives = {drive};
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 41});
  for (const Instant& at : motion.instants) {
    EXPECT_LT(imbalance(m, at), 1e-11);
    const BodyState& body = at.bodies[0];
    const Vector3d end = body.pose.p_WL + body.pose.R_WL * rod.frame_b.p_LJ;
    EXPECT_NEAR((end - rod.frame_a.p_LJ).norm(), 0.3, 1e-10);
    // the rod pulls along itself and bears no moment
    EXPECT_LT(at.joints[1].f_W.cross(end - rod.frame_a.p_LJ).norm(), 1e-10);
    EXPECT_EQ(at.joints[1].t_W.norm(), 0.0);
  }
}

// What a type does not hold it leaves free; a screw's two coordinates are one
// motion, and a distance has none that a drive could prescribe.
TEST(JointTypes, HeldAndFreeMotionsAreSix) {
  for (const JointTraits& type : all_joint_types()) {
    const auto count = type.rows.size() + type.coordinates.size();
    const bool has_all =
        type.type != JointType::kScrew && type.type != JointType::kDistance;
    if (has_all) EXPECT_EQ(count, 6u) << type.name;
    EXPECT_LE(type.rows_in_plane, type.rows.size()) << type.name;
  }
}

TEST(JointTypes, TraitsAreThoseOfTheType) {
  for (const JointTraits& type : all_joint_types()) {
    EXPECT_EQ(&traits(type.type), &type);
    EXPECT_EQ(name_of(type.type), type.name);
    if (type.slides()) {
      const bool along_x = type.coordinates[0].name == "x";
      EXPECT_EQ(type.slide_axis(), along_x ? 0 : 2) << type.name;
    }
  }
  using enum JointType;
  EXPECT_TRUE(traits(kRevolute).takes_bearing);
  EXPECT_TRUE(traits(kCylindrical).takes_bearing);
  for (const JointType type : {kPrismatic, kSpherical, kWeld, kScrew}) {
    EXPECT_FALSE(traits(type).takes_bearing);
  }
  EXPECT_TRUE(traits(kRevolute).is_hinge());
  EXPECT_FALSE(traits(kScrew).is_hinge());
}

}  // namespace
}  // namespace clevis::mechanism
