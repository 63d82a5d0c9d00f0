// Modes of small matrices against a dense solver and closed forms.

#include "dynamics/systems/eigenmodes.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "dynamics/load_vibration/load_shapes.h"
#include "dynamics/systems/attached_system.h"
#include "dynamics/systems/held_system.h"
#include "dynamics/systems/sprung_system.h"
#include "dynamics/systems/weighed_system.h"
#include "support/dense_system.h"

namespace clevis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd positive_matrix(int n, unsigned seed) {
  std::srand(seed);
  const MatrixXd a = MatrixXd::Random(n, n);
  return a * a.transpose() + 0.1 * MatrixXd::Identity(n, n);
}

support::EulerBeam unit_beam() {
  return {1.0, 1.0, 1.0, 20};
}

dynamics::LinearSystem free_beam() {
  auto system =
      support::dense_system(unit_beam().stiffness(), unit_beam().mass());
  system.rigid = MatrixXd::Zero(42, 2);
  for (int node = 0; node <= 20; ++node) {
    system.rigid(2 * node, 0) = 1.0;
    system.rigid(2 * node, 1) = node / 20.0;
    system.rigid(2 * node + 1, 1) = 1.0;
  }
  system.low_square = 1.0;
  return system;
}

TEST(Eigenmodes, MatchADenseSolver) {
  const MatrixXd k = positive_matrix(80, 1);
  const MatrixXd m = positive_matrix(80, 2);
  const auto modes =
      dynamics::lowest_modes(support::dense_system(k, m), 12, "test");
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> dense(k, m);
  ASSERT_EQ(modes.squares.size(), 12);
  EXPECT_EQ(modes.rigid, 0);
  EXPECT_LT((modes.squares - dense.eigenvalues().head(12))
                .cwiseQuotient(dense.eigenvalues().head(12))
                .cwiseAbs()
                .maxCoeff(),
            1e-10);
  EXPECT_LT(
      (modes.shapes.transpose() * m * modes.shapes - MatrixXd::Identity(12, 12))
          .cwiseAbs()
          .maxCoeff(),
      1e-10);
}

/// An eigenvalue that occurs five times is found five times.
TEST(Eigenmodes, FindMultipleEigenvaluesAsOftenAsTheyOccur) {
  VectorXd values(60);
  for (int i = 0; i < 60; ++i) values[i] = i < 5 ? 2.0 : 3.0 + i;
  std::srand(3);
  const Eigen::HouseholderQR<MatrixXd> qr(MatrixXd::Random(60, 60));
  const MatrixXd q = qr.householderQ();
  const MatrixXd k = q * values.asDiagonal() * q.transpose();
  const auto modes = dynamics::lowest_modes(
      support::dense_system(k, MatrixXd::Identity(60, 60)), 7, "test");
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(modes.squares[i], 2.0, 1e-10);
  EXPECT_NEAR(modes.squares[5], 8.0, 1e-9);
  EXPECT_NEAR(modes.squares[6], 9.0, 1e-9);
}

/// Cantilever: β l = 1.875104 and 4.694091 of cos β l cosh β l = −1.
TEST(Eigenmodes, CantileverOfBeamElements) {
  const support::EulerBeam beam{1.0, 1.0, 1.0, 20};
  const auto modes = dynamics::lowest_modes(
      support::dense_system(support::without_first(beam.stiffness(), 2),
                            support::without_first(beam.mass(), 2)),
      2, "test");
  EXPECT_NEAR(std::sqrt(modes.squares[0]), 1.875104069 * 1.875104069, 1e-6);
  EXPECT_NEAR(std::sqrt(modes.squares[1]), 4.694091133 * 4.694091133, 1e-4);
}

/// Free-free: two rigid motions, exactly zero, then cos β l cosh β l = 1.
TEST(Eigenmodes, FreeBeamHasItsRigidMotionsFirst) {
  const auto modes = dynamics::lowest_modes(free_beam(), 4, "test");
  EXPECT_EQ(modes.rigid, 2);
  EXPECT_EQ(modes.squares[0], 0.0);
  EXPECT_EQ(modes.squares[1], 0.0);
  EXPECT_NEAR(std::sqrt(modes.squares[2]), 4.730040745 * 4.730040745, 1e-4);
  EXPECT_LT(modes.residual.maxCoeff(), 1e-7);
}

// A beam on a pin at one end, where a spring holds its turning, against the
// dense system. On a soft one it swings as if it were rigid, 3 k/m l²; a stiff
// one clamps it.
TEST(Eigenmodes, BeamOnAPinWithASpring) {
  MatrixXd constraints = MatrixXd::Zero(42, 1);
  constraints(0, 0) = 1.0;
  const auto beam = free_beam();
  for (const double stiffness : {1e-4, 1.0, 1e6}) {
    MatrixXd spring = MatrixXd::Zero(42, 1);
    spring(1, 0) = std::sqrt(stiffness);
    const auto sprung = dynamics::sprung_system(beam, spring);
    EXPECT_EQ(sprung.rigid.cols(), 1);  // it still moves across
    const auto held = dynamics::held_system(sprung, constraints);
    EXPECT_EQ(held.rigid.cols(), 0);
    const auto modes = dynamics::lowest_modes(held, 2, "test");
    MatrixXd k = unit_beam().stiffness();
    k(1, 1) += stiffness;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> dense(
        k.bottomRightCorner(41, 41),
        unit_beam().mass().bottomRightCorner(41, 41), Eigen::EigenvaluesOnly);
    EXPECT_EQ(modes.rigid, 0);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(modes.squares[i] / dense.eigenvalues()[i], 1.0, 1e-5);
    }
    if (stiffness < 1e-3) {
      EXPECT_NEAR(modes.squares[0], 3e-4, 1e-8);
    }
    if (stiffness > 1e3) {
      EXPECT_NEAR(std::pow(modes.squares[0], 0.25), 1.875104, 1e-4);
    }
  }
}

// A mass of 1 beside the beam, joined to its end by a constraint, is one that
// it carries.
TEST(Eigenmodes, AttachedMassIsOneThatTheBeamCarries) {
  MatrixXd clamp = MatrixXd::Zero(43, 3);
  clamp(0, 0) = clamp(1, 1) = 1.0;
  clamp(40, 2) = 1.0;
  clamp(42, 2) = -1.0;
  const auto both = dynamics::attached_system(free_beam(), 1);
  EXPECT_EQ(both.size, 43);
  EXPECT_EQ(both.rigid.cols(), 3);
  const auto held = dynamics::held_system(both, clamp);
  EXPECT_EQ(held.rigid.cols(), 0);
  const auto modes = dynamics::lowest_modes(held, 2, "test");
  EXPECT_NEAR(std::pow(modes.squares[0], 0.25), 1.247917410, 1e-6);
  EXPECT_NEAR(std::pow(modes.squares[1], 0.25), 4.031139437, 1e-5);
}

}  // namespace
// Held by constraints a free beam is the cantilever, the pinned one (tan β l =
// tanh β l, β l = 3.926602, free to turn) or the one on two pins (β l = π).
TEST(HeldSystem, FreeBeamHeldIsTheHeldBeam) {
  const auto lowest = [](const std::vector<int>& held, int rigid) {
    MatrixXd constraints = MatrixXd::Zero(42, held.size());
    for (std::size_t k = 0; k < held.size(); ++k) {
      constraints(held[k], static_cast<Eigen::Index>(k)) = 7.0;  // any size
    }
    const auto modes = dynamics::lowest_modes(
        dynamics::held_system(free_beam(), constraints), rigid + 2, "test");
    EXPECT_EQ(modes.rigid, rigid);
    EXPECT_LT((constraints.transpose() * modes.shapes).norm(), 1e-10);
    return std::pow(modes.squares[rigid], 0.25);
  };
  EXPECT_NEAR(lowest({0, 1}, 0), 1.875104069, 1e-6);
  EXPECT_NEAR(lowest({0}, 1), 3.926602312, 1e-5);
  EXPECT_NEAR(lowest({0, 40}, 0), std::numbers::pi, 1e-5);
  EXPECT_NEAR(lowest({0, 40, 20}, 0), 2.0 * std::numbers::pi, 1e-4);
}

// A space far beyond what the loads excite keeps to the constraints: round-off
// that breaks them would grow.
TEST(HeldSystem, ShapesKeepToTheConstraints) {
  MatrixXd constraints = MatrixXd::Zero(42, 2);
  constraints(0, 0) = constraints(1, 1) = 1.0;
  const auto free = free_beam();
  const auto held = dynamics::held_system(free, constraints);
  const MatrixXd load = MatrixXd::Random(42, 1);
  const MatrixXd answer = dynamics::moved_to_constraints(
      free, constraints, held.factor(held.low_square)(load));
  EXPECT_LT((constraints.transpose() * answer).norm(), 1e-12);
  dynamics::LoadShapes space(held, answer);
  const auto shapes = space.shapes(38);
  EXPECT_LT((constraints.transpose() * shapes.columns).norm(),
            1e-9 * shapes.columns.norm());
  EXPECT_NEAR(std::pow(shapes.squares[0], 0.25), 1.875104069, 1e-6);
}

// A mass at the tip: 1 + cos β cosh β + μ β (cos β sinh β − sin β cosh β) = 0,
// and the shapes are orthogonal with it. Heavy ones take all of the motion.
TEST(WeighedSystem, CantileverWithAMassAtItsTip) {
  MatrixXd constraints = MatrixXd::Zero(42, 2);
  constraints(0, 0) = constraints(1, 1) = 1.0;
  const auto lowest = [&](double mass) {
    MatrixXd weight = MatrixXd::Zero(42, 1);
    weight(40, 0) = std::sqrt(mass);
    const auto free = dynamics::weighed_system(free_beam(), weight);
    const auto held = dynamics::held_system(free, constraints);
    const auto modes = dynamics::lowest_modes(held, 2, "test");
    EXPECT_EQ(modes.rigid, 0);
    EXPECT_LT((modes.shapes.transpose() * held.mass(modes.shapes) -
               MatrixXd::Identity(2, 2))
                  .norm(),
              1e-10);
    return modes.squares.array().pow(0.25).eval();
  };
  EXPECT_NEAR(lowest(1.0)[0], 1.247917410, 1e-6);
  EXPECT_NEAR(lowest(1.0)[1], 4.031139437, 1e-5);
  EXPECT_NEAR(lowest(30.0)[0], 0.561241873, 1e-6);
}

}  // namespace clevis
