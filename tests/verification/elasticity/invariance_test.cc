// What must not change the answer of loads, elasticity and stress together:
// place, units, numbering, supports, and solving instants in one block.

#include <array>
#include <cmath>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "support/elastic_field_problem.h"
#include "support/eye_problem.h"
#include "support/renumber.h"

namespace clevis {
namespace {

using Eigen::Vector3d;
using support::EyeProblem;

struct Answer {
  Eigen::VectorXd peak;    ///< per instant
  Eigen::VectorXd energy;  ///< per instant
};

Answer solve(const EyeProblem& eye, int degree = 2) {
  const auto basis = elasticity::solve<3>(eye.problem(), degree);
  return {stress::stress_history<3>(basis, eye.material, 3).peak,
          basis.strain_energy};
}

void expect_same(const Answer& got, const Answer& expected, double tolerance) {
  EXPECT_LT((got.peak.array() / expected.peak.array() - 1).abs().maxCoeff(),
            tolerance);
  EXPECT_LT((got.energy.array() / expected.energy.array() - 1).abs().maxCoeff(),
            tolerance);
}

TEST(Invariance, RotationAndTranslation) {
  const auto eye = support::eye_problem(3);
  const Answer here = solve(eye);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized())
          .toRotationMatrix();
  expect_same(solve(support::moved(eye, turn, Vector3d::Zero())), here, 1e-10);
  expect_same(solve(support::moved(eye, Eigen::Matrix3d::Identity(),
                                   Vector3d(0.3, -0.2, 0.1))),
              here, 1e-10);
  expect_same(solve(support::moved(eye, turn, Vector3d(0.3, -0.2, 0.1))), here,
              1e-10);
}

// Millimetre, newton and second: stress in MPa, energy in mJ.
TEST(Invariance, Units) {
  const auto eye = support::eye_problem(3);
  Answer in_mm = solve(support::in_units(eye, 1e-3, 1.0));
  in_mm.peak *= 1e6;
  in_mm.energy *= 1e-3;
  expect_same(in_mm, solve(eye), 1e-10);
}

TEST(Invariance, CellNumbering) {
  const auto eye = support::eye_problem(2);
  auto other = eye;
  other.mesh = support::shuffled(eye.mesh, 7);
  for (int degree : {2, 3}) {
    expect_same(solve(other, degree), solve(eye, degree), 1e-10);
  }
}

TEST(Invariance, CellOrientation) {
  const auto eye = support::eye_problem(2);
  for (unsigned seed : {1U, 2U, 3U}) {
    auto other = eye;
    other.mesh = support::reoriented(eye.mesh, seed);
    expect_same(solve(other, 3), solve(eye, 3), 1e-10);
  }
}

EyeProblem single_instant(const EyeProblem& eye, std::size_t instant) {
  EyeProblem single = eye;
  single.history.instants = {eye.history.instants[instant]};
  return single;
}

// As many independent instants as columns: nothing is compressed away.
TEST(Invariance, SuperpositionOfFullRankIsTheDirectSolution) {
  const auto eye = support::eye_problem(3);
  const Answer together = solve(eye);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Answer alone = solve(single_instant(eye, i));
    EXPECT_NEAR(together.peak[k] / alone.peak[0], 1.0, 1e-9);
    EXPECT_NEAR(together.energy[k] / alone.energy[0], 1.0, 1e-9);
  }
}

TEST(Invariance, SuperpositionOfManyInstantsKeepsSixDigits) {
  auto eye = support::eye_problem(60);
  for (auto& instant : eye.history.instants) {
    instant.wrenches[0].moment *= 0.1;
    instant.wrenches[1].moment *= 0.1;
  }
  const auto basis = elasticity::solve<3>(eye.problem(), 2);
  EXPECT_LT(basis.columns.cols(), 60);
  EXPECT_LE(basis.checks.compression, 1e-6);
  const auto history = stress::stress_history<3>(basis, eye.material, 3);
  for (std::size_t i : {std::size_t{0}, std::size_t{17}, std::size_t{59}}) {
    const Answer alone = solve(single_instant(eye, i));
    EXPECT_NEAR(history.peak[static_cast<Eigen::Index>(i)] / alone.peak[0], 1.0,
                1e-6);
  }
}

// A free part in balance leaves determinate supports without reaction, so
// that any choice gives the same stress.
TEST(Invariance, ChoiceOfDeterminateSupports) {
  const auto eye = support::eye_problem(1);
  const Answer own = solve(eye);
  const auto discretization = elasticity::discretize<3>(eye.mesh, 2);
  const auto node = [&](std::size_t vertex) {
    return 3 * discretization.vertex_nodes[vertex];
  };
  // Vertices on the bore at 0°, 90° and the rim at 180°, lower face.
  const std::vector<int> held = {node(0),     node(0) + 1, node(0) + 2,
                                 node(9) + 1, node(9) + 2, node(4) + 2};
  const auto basis = support::solve_field<3>(eye.problem(), {}, 2, held);
  const auto history = stress::stress_history<3>(basis, eye.material, 3);
  EXPECT_NEAR(history.peak[0] / own.peak[0], 1.0, 1e-9);
}

/// Six components at three vertices that hold a part, the best of their nine.
std::vector<int> supports_at(
    const elasticity::Discretization<3>& discretization,
    const std::array<std::size_t, 3>& vertices) {
  const auto positions = elasticity::node_positions(discretization);
  const Eigen::MatrixXd modes = elasticity::rigid_modes<3>(
      positions, positions.col(discretization.vertex_nodes[vertices[0]]), 0.01);
  std::vector<int> dofs;
  Eigen::MatrixXd at(6, 9);
  for (std::size_t vertex : vertices) {
    for (int d = 0; d < 3; ++d) {
      const int dof = 3 * discretization.vertex_nodes[vertex] + d;
      at.col(static_cast<Eigen::Index>(dofs.size())) = modes.row(dof);
      dofs.push_back(dof);
    }
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(at);
  std::vector<int> held;
  for (Eigen::Index k = 0; k < 6; ++k) {
    held.push_back(
        dofs[static_cast<std::size_t>(qr.colsPermutation().indices()[k])]);
  }
  return held;
}

// Supports at bad places: vertices of one cell, and a triangle so flat that
// only `sliver` of its height keeps the part from turning about its base.
TEST(Invariance, BadlyPlacedSupports) {
  for (const double sliver : {1.0, 0.1, 0.01}) {
    auto eye = support::eye_problem(1);
    // Two vertices a step, bore and rim by turns; one layer has 16. Vertex 16
    // stands above 0; the plate gets thinner, so that 0, 1 and 16 near a line.
    for (auto& vertex : eye.mesh.vertices) vertex.z() *= sliver;
    for (auto& points : eye.mesh.cell_points) points.row(2) *= sliver;
    for (auto& group : eye.mesh.groups) {
      if (!group.cylinder) continue;
      group.cylinder->length *= sliver;
      group.cylinder->p_LC.z() *= sliver;
    }
    eye.history.seats[0].p_LS.z() *= sliver;
    eye.history.seats[1].p_LS.z() *= sliver;
    auto& wrenches = eye.history.instants[0].wrenches;
    for (auto& wrench : wrenches) {
      wrench.force.z() = wrench.moment.x() = wrench.moment.y() = 0.0;
    }
    eye.history.instants[0].rigid = {};
    wrenches[1] = {-wrenches[0].force, -wrenches[0].moment};
    const Answer own = solve(eye);
    const auto discretization = elasticity::discretize<3>(eye.mesh, 2);
    for (const auto& vertices :
         {std::array<std::size_t, 3>{0, 1, 16}, {0, 1, 2}, {0, 8, 16}}) {
      const auto basis = support::solve_field<3>(
          eye.problem(), {}, 2, supports_at(discretization, vertices));
      const auto history = stress::stress_history<3>(basis, eye.material, 3);
      EXPECT_NEAR(history.peak[0] / own.peak[0], 1.0, 1e-9)
          << "sliver " << sliver << ", vertices " << vertices[0] << ' '
          << vertices[1] << ' ' << vertices[2];
    }
  }
}

// Meshes carry their cylinders with degree 4; a displacement of lower degree
// must still know rigid rotations and see its loads in balance.
TEST(Invariance, GeometryOfHigherDegreeThanTheDisplacement) {
  const auto eye = support::eye_problem(3, 4);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Vector3d(2, 1, -1).normalized())
          .toRotationMatrix();
  const auto turned = support::moved(eye, turn, Vector3d(0.1, 0.2, -0.3));
  for (int degree : {1, 2, 3}) {
    const auto basis = elasticity::solve<3>(eye.problem(), degree);
    EXPECT_LT(basis.checks.balance, 1e-12) << degree;
    EXPECT_LT(basis.checks.equilibrium, 1e-9) << degree;
    expect_same(solve(turned, degree), solve(eye, degree), 1e-10);
  }
}

TEST(Invariance, RepeatsBitForBit) {
  const auto eye = support::eye_problem(4);
  const Answer first = solve(eye);
  const Answer second = solve(eye);
  EXPECT_EQ((first.peak - second.peak).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ((first.energy - second.energy).cwiseAbs().maxCoeff(), 0.0);
}

TEST(Invariance, UnloadedPartHasNoStress) {
  auto eye = support::eye_problem(2);
  for (auto& instant : eye.history.instants) {
    instant.wrenches = {{}, {}};
    instant.rigid = {};
  }
  const Answer answer = solve(eye);
  EXPECT_EQ(answer.peak.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(answer.energy.cwiseAbs().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace clevis
