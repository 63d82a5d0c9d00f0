// Trees in the coordinates of their joints against the same bodies with
// constraints: two formulations that share the forces alone.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "mechanism/dynamic_motion/dynamic_motion.h"
#include "mechanism/integration/initial_state.h"
#include "mechanism/integration/motion_integrator.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::VectorXd;
using namespace testing;

constexpr std::array kSpatial{JointType::kRevolute,    JointType::kPrismatic,
                              JointType::kCylindrical, JointType::kUniversal,
                              JointType::kSpherical,   JointType::kPlanar,
                              JointType::kScrew,       JointType::kWeld};
constexpr std::array kInPlane{JointType::kRevolute, JointType::kPrismatic,
                              JointType::kWeld, JointType::kCylindrical,
                              JointType::kSpherical};

class RandomTree {
 public:
  explicit RandomTree(unsigned seed) : random_(seed) {}

  double number() { return std::uniform_real_distribution(-1.0, 1.0)(random_); }
  Vector3d vector() { return {number(), number(), number()}; }
  Matrix3d rotation() {
    return Quaterniond(number(), number(), number(), number())
        .normalized()
        .toRotationMatrix();
  }
  int below(int n) {
    return static_cast<int>(random_() % static_cast<unsigned>(n));
  }

  /// Bodies on joints of every type in turn, either way round, each on one
  /// before it; the last one is free.
  MechanismDefinition spatial() {
    MechanismDefinition m;
    m.gravity_W = {0.0, 0.0, -9.81};
    for (std::size_t i = 0; i <= kSpatial.size(); ++i) {
      add_body(m, rotation(), vector());
      if (i < kSpatial.size()) add_joint(m, kSpatial[i], rotation(), vector());
    }
    add_springs(m);
    for (const int joint : {0, 2, 3, 5}) {
      if (below(2) == 0) drive(m, joint, joint == 0 ? 0 : 1);
    }
    if (below(2) == 0) add_motor(m, 6);
    return m;
  }

  MechanismDefinition in_plane() {
    MechanismDefinition m;
    m.gravity_W = {0.0, -9.81, 0.0};
    m.dimension = SpaceDimension::kPlanar;
    for (std::size_t i = 0; i <= kInPlane.size(); ++i) {
      add_body(m, turned(3.0 * number()), {number(), number(), 0.0});
      if (i == kInPlane.size()) break;
      Matrix3d axes = turned(3.0 * number());
      if (kInPlane[i] == JointType::kPrismatic) {
        axes =
            axes *
            Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitY()).toRotationMatrix();
      } else if (below(2) == 0) {
        axes.col(1) *= -1.0;
        axes.col(2) *= -1.0;
      }
      add_joint(m, kInPlane[i], axes, {number(), number(), 0.0});
    }
    add_springs(m);
    if (below(2) == 0) drive(m, 1, 0);
    if (below(2) == 0) add_motor(m, 0);
    return m;
  }

 private:
  void drive(MechanismDefinition& m, int joint, int coordinate) {
    DriveDefinition drive;
    drive.joint = joint;
    drive.coordinate = coordinate;
    drive.law = DriveLaw::kSine;
    drive.amplitude = 0.3;
    drive.frequency = 0.4;
    drive.place = "drive";
    m.drives.push_back(drive);
  }
  void add_motor(MechanismDefinition& m, int joint) {
    MotorLaw law;
    law.resistance = 1.0;
    law.inductance = 1e-2;
    law.flux = 0.5;
    law.rotor_inertia = 0.4;
    law.times = {0.0};
    law.volts = {5.0};
    m.elements.push_back(on_joint(joint, law));
  }

  void add_body(MechanismDefinition& m, const Matrix3d& R, const Vector3d& p) {
    BodyDefinition body;
    body.name = "body_" + std::to_string(m.bodies.size());
    body.place = "body " + body.name;
    body.placement = {.p_WL = p, .R_WL = R};
    body.mass_properties.mass = 1.5 + number();
    body.mass_properties.p_LCm = {number(), number(), 0.0};
    const Matrix3d axes = turned(number());
    body.mass_properties.inertia_LCm =
        axes * Vector3d(0.5, 0.6, 0.9 + 0.1 * number()).asDiagonal() *
        axes.transpose();
    m.bodies.push_back(body);
  }

  /// Of the last body.
  void add_joint(MechanismDefinition& m, JointType type, const Matrix3d& axes_W,
                 const Vector3d& p_W) {
    const int last = static_cast<int>(m.bodies.size()) - 1;
    const int other = below(last + 1) - 1;  // −1: ground
    const auto frame = [&](int body) {
      if (body < 0) return JointFrame{p_W, axes_W};
      const Pose& pose = m.bodies[static_cast<std::size_t>(body)].placement;
      return JointFrame{pose.R_WL.transpose() * (p_W - pose.p_WL),
                        pose.R_WL.transpose() * axes_W};
    };
    JointDefinition joint;
    joint.name = "joint_" + std::to_string(m.joints.size());
    joint.place = "joint " + joint.name;
    joint.type = type;
    joint.body_a = other;
    joint.body_b = last;
    if (below(2) == 0 && type != JointType::kScrew) {
      std::swap(joint.body_a, joint.body_b);
    }
    if (joint.body_b < 0) std::swap(joint.body_a, joint.body_b);
    joint.frame_a = frame(joint.body_a);
    joint.frame_b = frame(joint.body_b);
    if (type == JointType::kScrew) joint.lead = 0.7;
    m.joints.push_back(joint);
  }

  /// From the ground to each body, stiff enough to turn it about.
  void add_springs(MechanismDefinition& m) {
    for (std::size_t i = 0; i < m.bodies.size(); ++i) {
      LineElement spring;
      spring.name = "spring_" + std::to_string(i);
      spring.line.kind = ElementLine::Kind::kDistance;
      spring.line.a = {.body = kGround, .p_L = {3.0, 4.0, 0.0}};
      spring.line.b = {.body = static_cast<int>(i), .p_L = {0.3, 0.2, 0.0}};
      spring.law = SpringLaw{.stiffness = 20.0, .damping = 0.1};
      m.elements.push_back(spring);
    }
  }

  std::mt19937 random_;
};

constexpr double kTime = 0.3;  // drives have started

struct Both {
  explicit Both(const MechanismDefinition& given)
      : definition(given),
        frame(frame_at_centres(definition)),
        dynamics(definition, frame, 1e-11, 1.0),
        equations(dynamics.equations()),
        projection(dynamics.projection()),
        coordinates(*JointCoordinates::of(frame, definition.drives)),
        tree(definition, dynamics, coordinates) {
    const InitialState initial =
        initial_state(definition, frame, equations.system(), 1e-8);
    y = equations.start(initial.x);
    projection.project(0.0, y);
    equations.accept(0.0, y);
    dynamics.note_speed(y);
    z.setZero(tree.size());
    tree.start(0.0, y, z);
  }

  Index work_index() const {
    return z.size() - 1 - 2 * static_cast<Index>(coordinates.driven().size());
  }
  /// Some other state of the tree.
  void move(RandomTree& random) {
    for (Index i = 0; i < work_index(); ++i) z[i] += random.number();
    tree.expand(kTime, z, y);
    projection.project(kTime, y);  // quaternions to length 1
    tree.read(kTime, y, z);
    equations.accept(kTime, y);
  }

  MechanismDefinition definition;
  SolvingFrame frame;
  ForwardDynamics dynamics;
  EquationsOfMotion& equations;
  Projection& projection;
  JointCoordinates coordinates;
  TreeSystem tree;
  VectorXd y, z;
};

/// Joints hold; y tells z and z tells y.
void expect_same_states(Both& both) {
  VectorXd again = both.y;
  both.tree.expand(kTime, both.z, again);
  EXPECT_LT(both.projection.gap(kTime, again), 1e-12);
  VectorXd other = both.z;
  both.tree.read(kTime, again, other);
  EXPECT_LT((other - both.z).lpNorm<Eigen::Infinity>(), 1e-12);
}

/// Accelerations, as differences of velocities over a short time.
void expect_same_accelerations(Both& both) {
  constexpr double kStep = 1e-4;
  VectorXd slope(both.z.size()), expected(both.y.size());
  both.tree.rate(kTime, both.z, slope);
  both.dynamics.rate(kTime, both.y, expected);
  VectorXd seen = VectorXd::Zero(both.y.size()), state = both.y;
  // fourth order
  for (const auto& [at, weight] : {std::pair{-2.0, 1.0 / 12.0},
                                   {-1.0, -2.0 / 3.0},
                                   {1.0, 2.0 / 3.0},
                                   {2.0, -1.0 / 12.0}}) {
    both.tree.expand(kTime + at * kStep, both.z + at * kStep * slope, state);
    seen += weight / kStep * state;
  }
  const Index from = both.equations.layout().velocity_index();
  const Index count = both.equations.layout().internal_index() - from;
  const VectorXd a = seen.segment(from, count);
  const VectorXd b = expected.segment(from, count);
  EXPECT_LT((a - b).lpNorm<Eigen::Infinity>(),
            1e-8 * b.lpNorm<Eigen::Infinity>());
  const double power = expected[expected.size() - 1];
  EXPECT_NEAR(slope[both.work_index()], power, 1e-11 * (1.0 + std::abs(power)));
}

TEST(JointCoordinates, StatesAndAccelerationsOfRandomTrees) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomTree random(seed);
    Both both(seed % 2 == 0 ? random.spatial() : random.in_plane());
    EXPECT_EQ(both.frame.planar, seed % 2 == 1);
    for (int i = 0; i < 3; ++i) {
      both.move(random);
      expect_same_states(both);
      expect_same_accelerations(both);
    }
  }
}

/// State of the bodies after a second, quaternions with w > 0.
template <typename Make>
VectorXd end_of(const MechanismDefinition& definition, const Make& make) {
  Both both(definition);
  auto integrator = make(both);
  integrator->restart(0.0, both.y, 0.0);
  VectorXd y = both.y;
  while (integrator->t() < 1.0) {
    EXPECT_TRUE(integrator->step(1.0));
    y = integrator->y();
    both.projection.project(integrator->t(), y);
    both.equations.accept(integrator->t(), y);
    integrator->correct(y);
  }
  for (Index i = 3;
       !both.frame.planar && i < both.equations.layout().velocity_index();
       i += 7) {
    if (y[i + 3] < 0.0) y.segment<4>(i) *= -1.0;
  }
  return y;
}

TEST(JointCoordinates, MotionsOfRandomTrees) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    RandomTree random(seed);
    const MechanismDefinition m =
        seed % 2 == 0 ? random.spatial() : random.in_plane();
    for (const numerics::IntegratorChoice choice :
         {numerics::IntegratorChoice::kExplicit,
          numerics::IntegratorChoice::kImplicit}) {
      const VectorXd a = end_of(m, [choice](Both& both) {
        return std::make_unique<MotionIntegrator>(both.definition, both.frame,
                                                  both.dynamics, choice);
      });
      const VectorXd b = end_of(m, [choice](Both& both) {
        return std::make_unique<numerics::SwitchingIntegrator>(both.dynamics,
                                                               choice);
      });
      EXPECT_LT((a - b).lpNorm<Eigen::Infinity>(),
                1e-8 * b.lpNorm<Eigen::Infinity>());
    }
  }
}

/// A hinge that a drive winds up by 40 rad, in steps of many turns.
MechanismDefinition winch(SpaceDimension dimension) {
  MechanismDefinition m = sliders({1.0, 1.0});
  m.joints[0].type = JointType::kRevolute;
  m.joints[0].frame_a = m.joints[0].frame_b = {};
  m.dimension = dimension;
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kQuintic;
  drive.to = 40.0;
  drive.duration = 5.0;
  drive.place = "drive";
  m.drives = {drive};
  return m;
}

TEST(JointCoordinates, ElementsCountTheTurnsOfLongSteps) {
  SimulationSettings settings;
  settings.duration = 5.0;
  settings.instants = 26;
  for (const SpaceDimension dimension :
       {SpaceDimension::kPlanar, SpaceDimension::kSpatial}) {
    MechanismDefinition m = winch(dimension);
    TableLaw table;
    table.positions = {0.0, 30.0, 31.0};
    table.efforts = {0.0, 0.0, -50.0};
    m.elements = {on_joint(0, SpringLaw{.stiffness = 1.0}), on_joint(0, table)};
    for (const Instant& at : simulate(m, settings).instants) {
      const double q = at.drives[0].position;
      EXPECT_NEAR(at.elements[0].effort, -q, 1e-9);
      EXPECT_NEAR(at.elements[1].effort, -50.0 * std::clamp(q - 30.0, 0.0, 1.0),
                  1e-7);
    }
  }
}

// What is free rests, and would allow one step over all periods of the drive.
TEST(JointCoordinates, StepsResolveWhatDrivesDo) {
  MechanismDefinition m = sliders({1.0, 0.01});
  m.gravity_W.setZero();
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.1;
  drive.frequency = 208.7;
  drive.duration = 10.0;
  drive.place = "drive";
  m.drives = {drive};
  SimulationSettings settings;
  settings.duration = 0.1;
  settings.instants = 7;
  const Motion motion = simulate(m, settings);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-6);
  const double omega = 2.0 * M_PI * drive.frequency;
  const double most = 0.1 * omega * omega;  // of 1 kg
  for (const Instant& at : motion.instants) {
    EXPECT_NEAR(at.drives[0].effort, -most * std::sin(omega * at.t),
                1e-9 * most);
  }
}

// Free turning about the second axis of a universal joint, on a spring.
TEST(JointCoordinates, SecondAngleOfAUniversalJointCountsTurns) {
  MechanismDefinition m = sliders({1.0});
  m.joints[0].type = JointType::kUniversal;
  m.joints[0].frame_a = m.joints[0].frame_b = {};
  m.gravity_W.setZero();
  const double inertia = m.bodies[0].mass_properties.inertia_LCm(0, 0);
  LineElement spring = on_joint(0, SpringLaw{.stiffness = inertia});
  spring.line.coordinate = 1;
  m.elements = {spring};
  m.initial_bodies = {{.body = 0,
                       .v_WLo = Vector3d::Zero(),
                       .w_WL = {30.0, 0.0, 0.0},
                       .place = "initial"}};
  SimulationSettings settings;
  settings.duration = 10.0;
  settings.instants = 41;
  for (const Instant& at : simulate(m, settings).instants) {
    EXPECT_NEAR(at.elements[0].position, 30.0 * std::sin(at.t), 1e-6);
  }
}

}  // namespace
}  // namespace clevis::mechanism
