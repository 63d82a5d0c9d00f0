// Reactions that equilibrium leaves open: which, how they are shared, and
// that units, frames, the order of joints and the cut do not matter.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mechanism/definition/drive_names.h"
#include "mechanism/joints/joint_types.h"
#include "mechanism/simulate.h"
#include "mechanism/structure/structure.h"
#include "support/bennett.h"
#include "support/newton_euler.h"

namespace clevis::mechanism {
namespace {

using namespace testing;
using Eigen::VectorXd;
using Wrench = Eigen::Matrix<double, 6, 1>;

/// A door of 10 kg on two hinges 0.6 m apart, its centre 0.4 m beside them,
/// held by a drive at the lower one. Gravity along the hinges' common axis.
MechanismDefinition door() {
  MechanismDefinition m;
  BodyDefinition body;
  body.name = "door";
  body.place = "body door";
  body.mass_properties = bar(10.0, 0.4, 0.0, 0.5);
  m.bodies = {body};
  for (const double z : {-0.3, 0.3}) {
    JointDefinition hinge;
    hinge.name = z < 0.0 ? "lower" : "upper";
    hinge.type = JointType::kRevolute;
    hinge.body_b = 0;
    hinge.frame_a.p_LJ = hinge.frame_b.p_LJ = {0.0, 0.0, z};
    m.joints.push_back(hinge);
  }
  DriveDefinition drive;
  drive.law = DriveLaw::kConstant;
  m.drives = {drive};
  m.gravity_W = {0.0, 0.0, -9.81};
  m.dimension = SpaceDimension::kSpatial;
  return m;
}

Instant first_instant(const MechanismDefinition& m) {
  return simulate(m, {.duration = 1.0, .instants = 2}).instants[0];
}

JointCompliance compliance(double force, double moment) {
  return {Vector3d::Constant(force), Vector3d::Constant(moment)};
}

// Force compliance c, moment compliance k. Tilting by θ moves the hinges by
// ∓0.3 θ across: the pair carries 98.1 N × 0.4 m as 2 (0.3²/c + 1/k) θ.
TEST(Reactions, DoorOnTwoHingesByItsStiffnesses) {
  MechanismDefinition m = door();
  constexpr double c = 2e-9, k = 5e-8;
  for (JointDefinition& hinge : m.joints) hinge.compliance = compliance(c, k);
  const Instant at = first_instant(m);
  const double moment = 10.0 * 9.81 * 0.4;
  const double theta = moment / (2.0 * (0.09 / c + 1.0 / k));
  const Wrench lower = at.joints[0].components();
  const Wrench upper = at.joints[1].components();
  EXPECT_NEAR(lower[2], 49.05, 1e-9);
  EXPECT_NEAR(upper[2], 49.05, 1e-9);
  EXPECT_NEAR(upper[0], -0.3 * theta / c, 1e-8);
  EXPECT_NEAR(lower[0], 0.3 * theta / c, 1e-8);
  EXPECT_NEAR(std::abs(upper[4]), theta / k, 1e-8);
  for (const JointReaction& r : at.joints) {
    EXPECT_EQ(r.unique_components,
              (std::array<bool, 6>{false, false, false, false, false, true}));
  }
}

TEST(Reactions, SofterHingeCarriesLess) {
  MechanismDefinition m = door();
  m.joints[0].compliance = compliance(3e-9, 1e-6);
  m.joints[1].compliance = compliance(1e-9, 1e-6);
  const Instant at = first_instant(m);
  // springs side by side: 1 : 3
  EXPECT_NEAR(at.joints[0].components()[2], 98.1 / 4.0, 1e-9);
  EXPECT_NEAR(at.joints[1].components()[2], 98.1 * 3.0 / 4.0, 1e-9);
}

// dw_i = Σ_k (∂w_i/∂ln c_k) ln 2 at worst: each derivative by differences.
TEST(Reactions, SpreadIsTheSumOfTheChangesPerCompliance) {
  MechanismDefinition m = door();
  m.gravity_W = {1.0, -3.0, -9.0};
  m.joints[0].compliance = compliance(3e-9, 4e-8);
  m.joints[1].compliance = compliance(1e-9, 2e-8);
  const Instant at = first_instant(m);
  std::array<Wrench, 2> sum{Wrench::Zero(), Wrench::Zero()};
  constexpr double h = 1e-4;
  for (JointDefinition& hinge : m.joints) {
    for (int k = 0; k < 6; ++k) {
      double& c =
          k < 3 ? hinge.compliance->force[k] : hinge.compliance->moment[k - 3];
      const double before = c;
      c = before * std::exp(h);
      const Instant more = first_instant(m);
      c = before * std::exp(-h);
      const Instant less = first_instant(m);
      c = before;
      for (std::size_t j = 0; j < 2; ++j) {
        sum[j] += (more.joints[j].components() - less.joints[j].components())
                      .cwiseAbs() /
                  (2.0 * h) * std::numbers::ln2;
      }
    }
  }
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(at.joints[j].spread[k], sum[j][static_cast<int>(k)], 1e-5);
    }
    EXPECT_EQ(at.joints[j].spread[5], 0.0);
    EXPECT_GT(at.joints[j].spread[2], 1.0);
  }
}

/// @return  reactions in the middle of a swing of the door, taken as spatial
///   or planar.
Instant swinging_door(MechanismDefinition m, SpaceDimension dimension,
                      bool driven) {
  m.dimension = dimension;
  m.drives[0].law = DriveLaw::kQuintic;
  m.drives[0].to = 1.5;
  m.drives[0].duration = 1.0;
  if (!driven) {
    m.drives.clear();
    m.initial_joints = {{.joint = 0, .position = {}, .rate = 2.0, .place = ""}};
  }
  return simulate(m, {.duration = 1.0, .instants = 4}).instants[1];
}

// A plane of motion does not tell how far apart the hinges are.
TEST(Reactions, DoorTakenAsPlanarCarriesThePair) {
  for (const bool driven : {true, false}) {
    MechanismDefinition m = door();
    m.bodies[0].mass_properties.p_LCm.z() = 0.1;
    m.joints[0].compliance = compliance(3e-9, 4e-8);
    m.joints[1].compliance = compliance(1e-9, 2e-8);
    const Instant space = swinging_door(m, SpaceDimension::kSpatial, driven);
    for (const auto as : {SpaceDimension::kAuto, SpaceDimension::kPlanar}) {
      const Instant plane = swinging_door(m, as, driven);
      for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_LT((plane.joints[j].components() - space.joints[j].components())
                      .norm(),
                  1e-7);
        EXPECT_EQ(plane.joints[j].unique_components,
                  space.joints[j].unique_components);
        for (std::size_t k = 0; k < 6; ++k) {
          EXPECT_NEAR(plane.joints[j].spread[k], space.joints[j].spread[k],
                      1e-6);
        }
      }
      if (driven) {
        EXPECT_NEAR(plane.drives[0].effort, space.drives[0].effort, 1e-9);
      }
    }
  }
}

/// Largest difference of forces and of moments over `length`.
double difference(const Instant& a, const Instant& b, double length) {
  double worst = 0.0;
  for (std::size_t j = 0; j < a.joints.size(); ++j) {
    const Wrench d = a.joints[j].components() - b.joints[j].components();
    worst = std::max({worst, d.head<3>().norm(), d.tail<3>().norm() / length});
  }
  return worst;
}

double largest_force(const Instant& at) {
  double scale = 0.0;
  for (const auto& r : at.joints) scale = std::max(scale, r.f_W.norm());
  return scale;
}

TEST(Bennett, ReferenceAngleAndCounts) {
  EXPECT_NEAR(Bennett().b(), 0.577350269190, 5e-13);
  const MechanismDefinition m = bennett({}, 70.0 * std::numbers::pi / 180.0);
  const Structure s = analyse_structure(m);
  EXPECT_EQ(s.spatial_chebyshev, -2);  // 20 constraints on 18 motions
  EXPECT_EQ(s.mobility, 1);            // rank 17
  EXPECT_EQ(s.redundant, 3);
  const Instant at = first_instant(m);
  // angle of hinge 2: from x of link P to x of link Q about the hinge
  const Matrix3d J = at.bodies[0].pose.R_WL * m.joints[1].frame_a.R_LJ;
  const Vector3d x = at.bodies[1].pose.R_WL.col(0);
  EXPECT_NEAR(std::atan2(J.col(1).dot(x), J.col(0).dot(x)), -2.639805930424,
              5e-13);
}

TEST(Bennett, NoPinReactionIsUniqueAndAllIsInBalance) {
  const MechanismDefinition m = bennett({}, 1.2);
  const Motion motion = simulate(m, {.duration = 1.0, .instants = 21});
  for (const Instant& at : motion.instants) {
    EXPECT_LT(imbalance(m, at), 1e-11);
    EXPECT_LT(at.power_balance_error, 1e-12);
    for (const JointReaction& r : at.joints) {
      for (int k = 0; k < 5; ++k) {
        EXPECT_FALSE(r.unique_components[static_cast<std::size_t>(k)]);
      }
      EXPECT_TRUE(r.unique_components[5]);
    }
  }
}

// Weld the ground link's body in, so that ground cuts the loop elsewhere: the
// pins see the same forces.
TEST(Bennett, CutAndOrderDoNotMatter) {
  MechanismDefinition m = bennett({}, 1.2);
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    m.joints[j].compliance =
        compliance(1e-9 * (1.0 + static_cast<double>(j)), 3e-9);
  }
  MechanismDefinition other = m;
  std::ranges::reverse(other.joints);
  for (JointDefinition& joint : other.joints) {
    std::swap(joint.body_a, joint.body_b);
    std::swap(joint.frame_a, joint.frame_b);
  }
  other.drives[0].joint = 3;
  other.drives[0].from *= -1.0;  // seen from the other body
  other.drives[0].to *= -1.0;
  const SimulationSettings settings{.duration = 1.0, .instants = 11};
  const Motion a = simulate(m, settings), b = simulate(other, settings);
  for (std::size_t i = 0; i < a.instants.size(); ++i) {
    const Instant& p = a.instants[i];
    const Instant& q = b.instants[i];
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_LT((p.joints[j].f_W + q.joints[3 - j].f_W).norm(),
                1e-10 * largest_force(p));
      EXPECT_LT((p.joints[j].t_W + q.joints[3 - j].t_W).norm(),
                1e-10 * largest_force(p));
    }
  }
}

TEST(Reactions, SceneRotationDoesNotMatter) {
  const Matrix3d R =
      Eigen::AngleAxisd(2.1, Vector3d(1.0, 2.0, -0.5).normalized())
          .toRotationMatrix();
  MechanismDefinition gear = landing_gear();
  gear.elements = {wheel_load(0.14)};
  std::get<ConstantForce>(gear.elements[0]).point.p_L.z() = 0.02;
  gear.dimension = SpaceDimension::kSpatial;
  for (const MechanismDefinition& m : {bennett({}, 1.2), door(), gear}) {
    const Instant here = first_instant(m);
    const Instant there = first_instant(moved(m, R, {3.0, -1.0, 0.5}));
    EXPECT_LT(difference(here, there, 0.3), 1e-10 * largest_force(here));
  }
}

// The same mechanism in millimetres: lengths 1000 times larger, and with mass
// in tonnes forces remain newtons, moments are in N mm.
TEST(Reactions, UnitsDoNotMatter) {
  constexpr double mm = 1e3, tonne = 1e-3;
  for (const bool spatial_gear : {false, true}) {
    MechanismDefinition m = bennett({}, 1.2);
    if (spatial_gear) {
      m = landing_gear();
      m.elements = {wheel_load(0.14)};
      std::get<ConstantForce>(m.elements[0]).point.p_L.z() = 0.02;
      m.dimension = SpaceDimension::kSpatial;
    }
    for (std::size_t j = 0; j < m.joints.size(); ++j) {
      m.joints[j].compliance =
          compliance(1e-9 * (1.0 + static_cast<double>(j)), 7e-8);
    }
    for (const bool given : {true, false}) {
      MechanismDefinition metres = m;
      if (!given) {
        for (auto& joint : metres.joints) joint.compliance = std::nullopt;
      }
      MechanismDefinition other = metres;
      for (BodyDefinition& body : other.bodies) {
        body.placement.p_WL *= mm;
        body.mass_properties.mass *= tonne;
        body.mass_properties.p_LCm *= mm;
        body.mass_properties.inertia_LCm *= tonne * mm * mm;
      }
      for (JointDefinition& joint : other.joints) {
        joint.frame_a.p_LJ *= mm;
        joint.frame_b.p_LJ *= mm;
        if (!joint.compliance) continue;
        joint.compliance->force *= mm;   // mm/N
        joint.compliance->moment /= mm;  // rad/(N mm)
      }
      for (ForceElement& force : other.elements) {
        std::get<ConstantForce>(force).point.p_L *= mm;
      }
      for (DriveDefinition& drive : other.drives) {
        if (drives_angle(other, drive)) continue;
        drive.from *= mm;
        drive.to *= mm;
      }
      other.gravity_W *= mm;
      const Instant a = first_instant(metres);
      Instant b = first_instant(other);
      for (JointReaction& r : b.joints) r.t_W /= mm;
      EXPECT_LT(difference(a, b, 0.3), 1e-10 * largest_force(a));
      for (std::size_t j = 0; j < a.joints.size(); ++j) {
        EXPECT_EQ(a.joints[j].unique_components, b.joints[j].unique_components);
      }
    }
  }
}

TEST(Reactions, LandingGearInSpaceHasSixOpen) {
  MechanismDefinition m = landing_gear();
  m.dimension = SpaceDimension::kSpatial;
  m.elements = {wheel_load(0.14)};
  std::get<ConstantForce>(m.elements[0]).point.p_L.z() = 0.02;
  const Structure s = analyse_structure(m);
  EXPECT_EQ(s.redundant, 6);
  const Instant at = first_instant(m);
  EXPECT_LT(imbalance(m, at), 1e-11);
  for (const int j : {kA, kB, kC, kD, kE, kF}) {
    const auto& unique =
        at.joints[static_cast<std::size_t>(j)].unique_components;
    EXPECT_EQ(unique,
              (std::array<bool, 6>{true, true, false, false, false, true}));
  }
  // the weld of the wheel is no part of a loop
  EXPECT_TRUE(at.joints[kAxle].unique);
}

}  // namespace
}  // namespace clevis::mechanism
