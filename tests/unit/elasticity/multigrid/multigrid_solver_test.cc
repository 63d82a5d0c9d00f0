#include "elasticity/multigrid/multigrid_solver.h"

#include <cmath>
#include <cstring>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "elasticity/algebra/sparse_cholesky.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/multigrid/large_part.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/solid/solid_solve.h"
#include "support/annulus_mesh.h"
#include "support/eye_problem.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

part::Material material(double poissons_ratio) {
  return {"steel", 210e9, poissons_ratio, 7850.0, 355e6};
}

/// A bar bent along its length.
mesh::PartMesh<3> bar(const Eigen::Vector3d& size, std::array<int, 3> cells) {
  return support::structured_mesh<
      3>(cells, 2, [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    const double angle = 0.5 * x[0];
    const double radius = 2.0 * size[0] + size[1] * (x[1] - 0.5);
    return {radius * std::sin(angle), radius * std::cos(angle), size[2] * x[2]};
  });
}

mesh::PartMesh<3> ring() {
  return support::ring_mesh<3>({.inner = 0.01,
                                .outer = 0.02,
                                .thickness = 0.01,
                                .radial = 2,
                                .angular = 12,
                                .axial = 2,
                                .degree = 3});
}

std::vector<int> clamp(const Discretization<3>& discretization) {
  return fixed_supports<3>(discretization, node_positions(discretization),
                           {{"x0", {true, true, true}}}, "part P");
}

MatrixXd by_cholesky(const Discretization<3>& discretization,
                     const part::Material& material,
                     const std::vector<int>& held, const MatrixXd& loads) {
  const auto numbers = number_equations(discretization.dofs(), held);
  const SparseCholesky factor(
      free_equations(assemble_stiffness(discretization, material, "part P"),
                     numbers),
      "part P");
  return extend_rows(factor.solve(restrict_rows(loads, numbers)), numbers);
}

double distance(const MatrixXd& u, const MatrixXd& wanted) {
  return (u - wanted).norm() / wanted.norm();
}

TEST(MultigridSolver, AgreesWithCholesky) {
  for (int degree = 2; degree <= 4; ++degree) {
    for (int coarse = 1; coarse < std::min(degree, 3); ++coarse) {
      const auto discretization = discretize<3>(ring(), degree);
      const auto held = clamp(discretization);
      // Not a multiple of the lanes, and a column without load.
      MatrixXd loads = MatrixXd::Random(discretization.dofs(), 19);
      loads.col(7).setZero();
      MultigridOptions options;
      options.coarse_degree = coarse;
      MultigridSolver solver(discretization, material(0.3), held, "part P",
                             options);
      const MatrixXd u = solver.solve(loads);
      EXPECT_LT(
          distance(u, by_cholesky(discretization, material(0.3), held, loads)),
          1e-8)
          << degree << " to " << coarse;
      EXPECT_EQ(u.col(7).norm(), 0.0);
      EXPECT_LT(solver.report().residual, 1e-10);
    }
  }
}

TEST(MultigridSolver, SolvesFreePartsInBalance) {
  const auto discretization = discretize<3>(ring(), 3);
  const auto positions = node_positions(discretization);
  const auto held = determinate_supports<3>(discretization, positions);
  const MatrixXd modes =
      rigid_modes<3>(positions, positions.rowwise().mean(), 0.02);
  MatrixXd loads = MatrixXd::Random(discretization.dofs(), 3);
  loads -= modes *
           (modes.transpose() * modes).ldlt().solve(modes.transpose() * loads);
  MultigridSolver solver(discretization, material(0.3), held, "part P");
  const MatrixXd u = solver.solve(loads);
  EXPECT_LT(
      distance(u, by_cholesky(discretization, material(0.3), held, loads)),
      1e-8);
  // Loads in balance leave the supports without reaction.
  const MatrixXd rest = solver.multiply(u) - loads;
  for (int dof : held) {
    EXPECT_LT(rest.row(dof).norm(), 1e-8 * loads.norm());
  }
}

TEST(MultigridSolver, IterationsStayFewOnSlenderBodies) {
  // ≤ 15 for a body of aspect 10, ≤ 25 for one of 100, to 1e-8.
  for (int degree = 2; degree <= 4; ++degree) {
    for (int aspect : {10, 100}) {
      if (aspect == 100 && degree == 4) continue;  // takes its time
      const auto discretization = discretize<3>(
          bar({0.02 * aspect, 0.02, 0.02}, {2 * aspect, 2, 2}), degree);
      MultigridOptions options;
      options.tolerance = 1e-8;
      MultigridSolver solver(discretization, material(0.3),
                             clamp(discretization), "part P", options);
      const auto positions = node_positions(discretization);
      MatrixXd loads(discretization.dofs(), 2);
      for (Eigen::Index n = 0; n < positions.cols(); ++n) {
        loads.col(0).segment<3>(3 * n) << 0.0, 1.0, 0.5;
        loads.col(1).segment<3>(3 * n) << std::sin(40.0 * positions(0, n)),
            positions(2, n), std::cos(300.0 * positions(1, n));
      }
      solver.solve(loads);
      EXPECT_LE(solver.report().iterations, aspect == 10 ? 15 : 25)
          << degree << " " << aspect;
    }
  }
}

TEST(MultigridSolver, StretchedCellsTakeHalfTheCycles) {
  const auto part =
      discretize<3>(bar({0.32, 0.02, 0.02}, {16, 4, 4}), 3);  // cells of 4:1
  const auto iterations = [&](int smoothing_steps) {
    MultigridOptions options;
    options.tolerance = 1e-8;
    options.smoothing_steps = smoothing_steps;
    MultigridSolver solver(part, material(0.3), clamp(part), "part P", options);
    MatrixXd loads = MatrixXd::Zero(part.dofs(), 1);
    for (Eigen::Index n = 0; n < part.nodes; ++n) loads(3 * n + 1, 0) = 1.0;
    solver.solve(loads);
    return solver.report().iterations;
  };
  constexpr int kOfCubes = 4;
  EXPECT_LE(iterations(0), 16);
  EXPECT_GE(iterations(kOfCubes), 3 * iterations(0) / 2);
}

TEST(LargePart, SolvesAsTheFactorDoes) {
  // A free eye, folded at its mirrors, by both ways.
  const auto eye = support::eye_problem(5, 3);
  auto problem = eye.problem();
  problem.solver = LinearSolver::kDirect;
  const auto direct = solve(problem, 3);
  problem.solver = LinearSolver::kMultigrid;
  const auto iterated = solve(problem, 3);
  EXPECT_LT(distance(iterated.columns * iterated.coefficients,
                     direct.columns * direct.coefficients),
            1e-8);
  EXPECT_LT((iterated.strain_energy - direct.strain_energy).norm(),
            1e-9 * direct.strain_energy.norm());
  EXPECT_LT(iterated.checks.equilibrium, 1e-9);
}

TEST(LargePart, ChoosesBySizeCellsAndMaterial) {
  constexpr double kMemory = 24e9;
  const auto cubes = discretize<3>(bar({0.3, 0.1, 0.1}, {6, 2, 2}), 2);
  const auto flat = discretize<3>(bar({0.3, 0.1, 0.01}, {6, 2, 2}), 2);
  EXPECT_NEAR(cell_aspect(cubes), 1.0, 0.1);
  EXPECT_NEAR(cell_aspect(flat), 10.0, 0.5);
  // Work of the factors over that of the iterations.
  const auto prefers = [&](const Discretization<3>& part, double poisson,
                           double ratio, double bytes) {
    const DirectCost cost{ratio * 1e6 * part.dofs(), bytes};
    return prefers_multigrid(part, material(poisson), cost, 40.0, kMemory);
  };
  EXPECT_FALSE(prefers(cubes, 0.3, 1.0, 1e9));
  EXPECT_TRUE(prefers(cubes, 0.3, 10.0, 1e9));
  EXPECT_FALSE(prefers(flat, 0.3, 10.0, 1e9));
  EXPECT_TRUE(prefers(flat, 0.3, 10.0, 30e9));
  EXPECT_TRUE(prefers(cubes, 0.3, 1.0, 30e9));
  EXPECT_FALSE(prefers(cubes, 0.4999, 10.0, 1e9));
  EXPECT_FALSE(suits_multigrid(discretize<3>(bar({1, 1, 1}, {1, 1, 1}), 1),
                               material(0.3)));
}

TEST(MultigridSolver, SameBitsForAnyNumberOfThreads) {
  const auto discretization = discretize<3>(ring(), 2);
  const auto held = clamp(discretization);
  const MatrixXd loads = MatrixXd::Random(discretization.dofs(), 5);
  MatrixXd one;
  for (int threads : {1, 2, 4}) {
    MultigridOptions options;
    options.threads = threads;
    MultigridSolver solver(discretization, material(0.3), held, "part P",
                           options);
    const MatrixXd u = solver.solve(loads);
    if (threads == 1) one = u;
    EXPECT_EQ(std::memcmp(one.data(), u.data(),
                          sizeof(double) * static_cast<std::size_t>(u.size())),
              0)
        << threads;
  }
}

}  // namespace
}  // namespace clevis::elasticity
