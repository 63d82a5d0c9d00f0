// Self-checks of solutions that are known in closed form: springs in a row.
#include "elasticity/problem/self_checks.h"

#include <limits>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "elasticity/assembly/supports.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kRoundOff = 1e-13;

TEST(SelfChecks, BalanceIsRestoredAndNothingElse) {
  const auto mesh = support::structured_mesh<3>(
      {2, 2, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return {0.2 * x[0], 0.05 * x[1], 0.01 * x[2]};
      });
  const auto part = discretize<3>(mesh, 2);
  const auto positions = node_positions(part);
  const MatrixXd modes = rigid_modes<3>(positions, Vector3d(0.1, 0, 0), 0.2);
  MatrixXd loads = MatrixXd::Random(part.dofs(), 3);
  const MatrixXd before = loads;
  restore_balance(modes, loads);
  const double size = before.cwiseAbs().colwise().sum().maxCoeff();
  EXPECT_LT((modes.transpose() * loads).cwiseAbs().maxCoeff(),
            kRoundOff * size);
  // What went is a rigid mode at the nodes; once is enough.
  const MatrixXd gone = before - loads;
  const MatrixXd fit =
      modes *
      (modes.transpose() * modes).ldlt().solve(modes.transpose() * gone);
  EXPECT_LT((gone - fit).norm(), kRoundOff * before.norm());
  const MatrixXd once = loads;
  restore_balance(modes, loads);
  EXPECT_LT((loads - once).norm(), kRoundOff * before.norm());
}

/// Springs k_1 and k_2 in a row: nodes 0 (held or free), 1, 2.
struct Row {
  static constexpr double kFirst = 200.0, kSecond = 300.0;  // [N/m]

  Row() : K(3, 3) {
    K << kFirst, -kFirst, 0.0,                //
        -kFirst, kFirst + kSecond, -kSecond,  //
        0.0, -kSecond, kSecond;
  }
  StiffnessAction action() const {
    return {[this](const MatrixXd& u) -> MatrixXd {
              return K * u;
            },
            [this](const MatrixXd& u) -> MatrixXd {
              return K.cwiseAbs() * u;
            }};
  }
  /// Displacements by a force of 1 N at node 2, node 0 at rest.
  VectorXd by_unit_force() const {
    return Vector3d(0.0, 1.0 / kFirst, 1.0 / kFirst + 1.0 / kSecond);
  }

  MatrixXd K;
};

/// Force at node 2 of 1 N times a factor by instant.
LoadBasis pull(const Eigen::RowVectorXd& factors) {
  return {.columns = Vector3d(0.0, 0.0, 1.0), .coefficients = factors};
}

TEST(SelfChecks, StrainEnergyOfSpringsInARow) {
  const Row row;
  const Eigen::RowVector3d factors(1.0, 0.0, -4.0);
  SolveChecks checks;
  const VectorXd energy = check_solution(row.action(), row.by_unit_force(),
                                         pull(factors), {0}, false, checks);
  const double unit = 0.5 * (1.0 / Row::kFirst + 1.0 / Row::kSecond);
  EXPECT_NEAR(energy[0], unit, kRoundOff);
  EXPECT_EQ(energy[1], 0.0);
  EXPECT_NEAR(energy[2], 16.0 * unit, 16.0 * kRoundOff);
  EXPECT_LT(checks.residual, kRoundOff);
  EXPECT_LT(checks.energy, kRoundOff);
  EXPECT_EQ(checks.equilibrium, 0.0);
  EXPECT_FALSE(wants_refinement(checks));
}

// u too large by a part: K u by that part, uᵀK u over fᵀu likewise.
TEST(SelfChecks, ErrorOfASolutionIsItsResidual) {
  const Row row;
  const double part = 3e-5;
  SolveChecks checks;
  check_solution(row.action(), (1.0 + part) * row.by_unit_force(),
                 pull(Eigen::RowVector2d(2.0, -1.0)), {0}, false, checks);
  EXPECT_NEAR(checks.residual, part, kRoundOff);
  EXPECT_NEAR(checks.energy, part, kRoundOff);
  EXPECT_GT(checks.residual_round_off, 0.0);
  EXPECT_TRUE(wants_refinement(checks));
}

// The force that the held node of a free part takes is what its loads leave of
// balance; the largest instant is that of factor 5.
TEST(SelfChecks, SupportsOfAFreePartShowItsImbalance) {
  const Row row;
  const double rest = 1e-4;
  LoadBasis loads = pull(Eigen::RowVector2d(5.0, 1.0));
  loads.columns(0, 0) = -1.0 + rest;
  SolveChecks free, held;
  check_solution(row.action(), row.by_unit_force(), loads, {0}, true, free);
  const double largest = 5.0 * loads.columns.norm();
  EXPECT_NEAR(free.equilibrium, 5.0 * rest / largest, kRoundOff);
  EXPECT_LT(free.residual, kRoundOff);
  check_solution(row.action(), row.by_unit_force(), loads, {0}, false, held);
  EXPECT_EQ(held.equilibrium, 0.0);
}

// Two classes of a part, each by half: the energies add up, the largest
// residual stays.
TEST(SelfChecks, ClassesAddUp) {
  const Row row;
  const LoadBasis loads = pull(Eigen::RowVectorXd::Ones(1));
  const Eigen::ArrayXd norms = Eigen::ArrayXd::Ones(1);
  const double part = 1e-3;
  SolveChecks checks;
  SolutionCheck check(1, 1.0);
  for (const double factor : {1.0 + part, 1.0}) {
    check.add(row.action(), factor * row.by_unit_force(), loads, norms, {0}, {},
              0.5, checks);
  }
  const double unit = 1.0 / Row::kFirst + 1.0 / Row::kSecond;
  const double square = (1.0 + part) * (1.0 + part);
  EXPECT_NEAR(check.strain_energy(checks)[0], 0.25 * unit * (square + 1.0),
              kRoundOff);
  EXPECT_NEAR(checks.residual, part, kRoundOff);
  EXPECT_NEAR(checks.energy, (square + 1.0) / (2.0 + part) - 1.0, kRoundOff);
}

/// What is refused; empty: nothing.
std::string breach(const SolveChecks& checks, int geometry_degree = 2) {
  try {
    require_checks(checks, geometry_degree, "P");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F003");
    EXPECT_EQ(error.place(), "part P");
    return error.problem().substr(0, error.problem().find(':'));
  }
  return "";
}

TEST(SelfChecks, BreachIsNamed) {
  EXPECT_EQ(breach({}), "");
  EXPECT_EQ(breach({.relief = 2e-3}), "self-check inertia relief");
  EXPECT_EQ(breach({.relief = 2e-3}, 1), "");  // faceted
  EXPECT_EQ(breach({.relief = 0.1}, 1), "self-check inertia relief");
  EXPECT_EQ(breach({.balance = 1e-11}), "self-check balance of loads");
  EXPECT_EQ(breach({.equilibrium = 1e-8}), "self-check support reactions");
  EXPECT_EQ(breach({.residual = 1e-7}), "self-check residual");
  EXPECT_EQ(breach({.energy = 1e-7}), "self-check energy");
  EXPECT_EQ(breach({.compression = 1e-5}), "self-check load compression");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(breach({.energy = nan}), "self-check energy");
}

// Round-off of K u that is larger than the bound excuses the residual as far
// as it goes.
TEST(SelfChecks, RoundOffExcusesTheResidual) {
  EXPECT_EQ(breach({.residual = 1e-7, .residual_round_off = 2e-7}), "");
  EXPECT_EQ(breach({.residual = 1e-7, .residual_round_off = 5e-8}),
            "self-check residual");
  EXPECT_EQ(breach({.equilibrium = 1e-8, .equilibrium_round_off = 2e-8}), "");
}

// From a tenth of a bound on, which another BLAS may reach.
TEST(SelfChecks, NearABoundWantsRefinement) {
  EXPECT_TRUE(wants_refinement({.equilibrium = 2e-10}));
  EXPECT_TRUE(wants_refinement({.residual = 2e-9}));
  EXPECT_TRUE(wants_refinement({.energy = 2e-9}));
  EXPECT_FALSE(wants_refinement(
      {.equilibrium = 5e-11, .residual = 5e-10, .energy = 5e-10}));
}

TEST(SelfChecks, NotANumberStays) {
  const Row row;
  VectorXd u = row.by_unit_force();
  u[1] = std::numeric_limits<double>::quiet_NaN();
  SolveChecks checks;
  check_solution(row.action(), u, pull(Eigen::RowVectorXd::Ones(1)), {0}, false,
                 checks);
  EXPECT_EQ(breach(checks), "self-check residual");
}

// A force at one corner of a free block: inertia relief takes up all of it,
// with its moments.
TEST(SelfChecks, InertiaReliefBalancesAFreePart) {
  const auto block =
      discretize<3>(support::structured_mesh<3>(
                        {2, 1, 1}, 1,
                        [](const Vector3d& x) -> Vector3d {
                          return {0.2 * x[0], 0.1 * x[1], 0.05 * x[2]};
                        }),
                    2);
  const auto positions = node_positions(block);
  MatrixXd history = MatrixXd::Zero(block.dofs(), 2);
  history(2, 0) = 1000.0;
  history(0, 1) = 1.0;
  SolveChecks checks;
  balance_free_part<3>(block, positions, 7800.0, history, checks);
  EXPECT_NEAR(checks.relief, 1.0, kRoundOff);  // nothing else was there
  EXPECT_LT(checks.balance, kRoundOff);
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  for (Eigen::Index node = 0; node < positions.cols(); ++node) {
    const Vector3d f = history.col(0).segment<3>(3 * node);
    force += f;
    moment += positions.col(node).cross(f);
  }
  EXPECT_LT(force.norm(), 1000.0 * kRoundOff);
  EXPECT_LT(moment.norm(), 1000.0 * kRoundOff);
}

}  // namespace
}  // namespace clevis::elasticity
