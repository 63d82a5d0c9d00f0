// A stiff governor and a spatial loop with a redundant constraint, against
// formulations of their own.
#include "support/benchmark_mechanisms.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism/equations_of_motion/projection.h"
#include "mechanism/integration/initial_state.h"
#include "mechanism/joints/joint_types.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "mechanism/simulate.h"
#include "mechanism/structure/structure.h"

namespace clevis::mechanism {
namespace {

SimulationSettings settings(double duration, int instants, double tolerance) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = tolerance;
  return s;
}

TEST(Governor, FollowsItsOwnEquations) {
  const testing::Governor values;
  testing::GovernorEquations equations(values);
  const Motion motion =
      simulate(testing::governor(values), settings(2.0, 5, 1e-8));
  for (const Instant& at : motion.instants) {
    if (at.t > 0.0) equations.advance(0.5, 100000);
    EXPECT_NEAR(-at.bodies[1].pose.p_WL.z(), equations.depth(), 1e-8);
    EXPECT_NEAR(at.bodies[0].w_WL.z(), equations.spin(), 1e-7);
    for (const std::size_t arm : {2, 3}) {
      const double lean = -at.bodies[arm].pose.R_WL.col(2).z();
      EXPECT_NEAR(-lean, std::cos(equations.angle()), 1e-8);
    }
  }
  EXPECT_GT(motion.integration->implicit_steps, 0);
  EXPECT_LT(motion.integration->evaluations, 70000);
}

// Newton's iterations must not know how stiff the springs are that turn with
// the arms: steps then end at a turn of (stiffness)^(-1/3).
TEST(Governor, StiffnessDoesNotEndNewtonsIterations) {
  for (const double stiffer : {1.0, 1e3}) {
    testing::Governor values;
    values.stiffness *= stiffer;
    values.damping *= stiffer;
    SimulationSettings s = settings(2.0, 2, 1e-4);
    s.integrator = numerics::IntegratorChoice::kImplicit;
    const Motion motion = simulate(testing::governor(values), s);
    EXPECT_LT(motion.integration->rejected, 10) << stiffer;
    EXPECT_LT(motion.integration->evaluations, 2000) << stiffer;
  }
}

// Body by body, outer ones first, against Cholesky of all rows at once.
TEST(TreeMass, AgreesWithAllRowsAtOnce) {
  MechanismDefinition m = testing::governor();
  const SolvingFrame frame = frame_at_centres(m);
  EquationsOfMotion equations(m, frame);
  const ConstraintSystem& system = equations.system();
  Eigen::VectorXd y = equations.start(initial_state(m, frame, system, 1e-8).x);
  Projection(equations).project(0.0, y);
  equations.solve(0.0, y);
  const int rows = system.rows();
  const Eigen::Index most = equations.constraints().most_rows();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(most, system.columns());
  ConstrainedMass tree = equations.constraints().mass(), all = tree;
  ASSERT_NE(tree.tree(), nullptr);
  system.fill_jacobian(equations.state().placed, J);
  all.factor(J, rows);
  Eigen::VectorXd gamma(most), Q(J.cols());
  for (Eigen::Index i = 0; i < most; ++i) gamma[i] = std::cos(i);
  for (Eigen::Index i = 0; i < Q.size(); ++i) Q[i] = std::sin(3 * i);
  Eigen::VectorXd a(J.cols()), of_all(J.cols()), lambda(most), by_all(most);
  tree.accelerate(gamma, Q, a, lambda);
  all.accelerate(gamma, Q, of_all, by_all);
  EXPECT_LT((a - of_all).norm(), 1e-12 * a.norm());
  EXPECT_LT((lambda - by_all).norm(), 1e-12 * lambda.norm());
}

/// The turn of hinge i: of bar i against the bar before it, about z, from the
/// right angle of the start.
double turn(const MechanismDefinition& m, const Instant& at, std::size_t i) {
  const JointDefinition& joint = m.joints[i];
  const auto axes = [&at](int body, const JointFrame& frame) {
    return body == kGround
               ? frame.R_LJ
               : Eigen::Matrix3d(
                     at.bodies[static_cast<std::size_t>(body)].pose.R_WL *
                     frame.R_LJ);
  };
  const Eigen::Matrix3d a = axes(joint.body_a, joint.frame_a);
  const Eigen::Matrix3d b = axes(joint.body_b, joint.frame_b);
  return std::atan2(a.col(1).dot(b.col(0)), a.col(0).dot(b.col(0)));
}

// Three turns are equal, and so are the other three; with equal bars their
// angles from straight, θ and φ, keep cos θ + cos φ + cos θ cos φ = 0.
TEST(Bricard, KeepsItsClosedFormAndItsEnergy) {
  const MechanismDefinition m = testing::bricard();
  const Structure s = analyse_structure(m);
  EXPECT_EQ(s.spatial_chebyshev, 0);
  EXPECT_EQ(s.mobility, 1);
  EXPECT_EQ(s.redundant, 1);
  const Motion motion = simulate(m, settings(10.0, 101, 1e-9));
  double largest = 0.0;
  for (const Instant& at : motion.instants) {
    std::array<double, 6> angle{};
    for (std::size_t i = 0; i < 6; ++i) {
      // the frames' x are those of the bar before: 90° at the start
      angle[i] = 0.5 * std::numbers::pi + turn(m, at, i);
    }
    for (std::size_t i = 2; i < 6; ++i) {
      EXPECT_NEAR(std::cos(angle[i]), std::cos(angle[i - 2]), 1e-8);
    }
    const double a = std::cos(angle[0]), b = std::cos(angle[1]);
    EXPECT_NEAR(a + b + a * b, 0.0, 1e-8);
    largest = std::max(largest, std::abs(a));
    bool any_open = false;
    for (const JointReaction& r : at.joints) any_open |= !r.unique;
    EXPECT_TRUE(any_open);
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(motion.integration->energy_error, 1e-7);
}

TEST(Bricard, FollowsItsOwnEquations) {
  testing::BricardEquations equations;
  const Motion motion = simulate(testing::bricard(), settings(2.0, 5, 1e-9));
  for (const Instant& at : motion.instants) {
    if (at.t > 0.0) equations.advance(0.5, 500);
    EXPECT_LT(equations.gap(), 1e-12);
    EXPECT_LT((at.bodies[3].pose.p_WL - equations.corner()).norm(), 1e-8);
  }
}

/// Kinetic energy at unit rate of the first angle and potential energy of
/// Bricard's mechanism, from its poses: masses of the bars as in the scene.
double potential(const MechanismDefinition& m, const Instant& at) {
  double sum = 0.0;
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    const auto& mass = m.bodies[i].mass_properties;
    const Pose& pose = at.bodies[i].pose;
    sum -= mass.mass * m.gravity_W.dot(pose.p_WL + pose.R_WL * mass.p_LCm);
  }
  return sum;
}

// The pace, by another formulation: driven through the same positions at unit
// rate, the mechanism has the energy M(θ)/2, so that θ' = √(2 (E − V)/M).
TEST(Bricard, MovesAtThePaceOfItsEnergy) {
  MechanismDefinition m = testing::bricard();
  const Motion motion = simulate(m, settings(1.0, 11, 1e-9));
  const double start = potential(m, motion.instants[0]);
  for (const std::size_t i : {3, 6, 9}) {
    const Instant& at = motion.instants[i];
    MechanismDefinition driven = m;
    for (std::size_t b = 0; b < m.bodies.size(); ++b) {
      driven.bodies[b].placement = at.bodies[b].pose;
    }
    const double here = turn(m, at, 0);
    DriveDefinition drive;
    drive.law = DriveLaw::kRamp;
    drive.from = here - 0.5;
    drive.to = here + 0.5;
    drive.start = -0.5;
    drive.duration = 1.0;
    driven.drives = {drive};
    SimulationSettings one = settings(1e-3, 2, 1e-10);
    one.motion = MotionKind::kDriven;
    const Instant unit = simulate(driven, one).instants[0];
    double twice = 0.0;
    for (std::size_t b = 0; b < m.bodies.size(); ++b) {
      const auto& mass = m.bodies[b].mass_properties;
      const BodyState& body = unit.bodies[b];
      const Eigen::Vector3d c = body.pose.R_WL * mass.p_LCm;
      const Eigen::Vector3d w = body.pose.R_WL.transpose() * body.w_WL;
      twice += mass.mass * (body.v_WLo + body.w_WL.cross(c)).squaredNorm() +
               w.dot(mass.inertia_LCm * w);
    }
    const auto axis = at.bodies[0].pose.R_WL * m.joints[0].frame_b.R_LJ.col(2);
    const double pace = std::abs(at.bodies[0].w_WL.dot(axis));
    EXPECT_NEAR(pace, std::sqrt(2.0 * (start - potential(m, at)) / twice),
                1e-7);
    EXPECT_GT(pace, 0.05);
  }
}

}  // namespace
}  // namespace clevis::mechanism
