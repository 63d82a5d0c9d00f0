// deal.II's solutions against those of our own factors, node by node: either
// engine is the other's oracle.
#include "elasticity/dealii/dealii_solver.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/dealii_space/level_degrees.h"
#include "elasticity/solid/solid_solve.h"
#include "support/annulus_mesh.h"
#include "support/eye_problem.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// What both engines must agree to: displacements over the largest [1].
constexpr double kAgreement = 1e-9;

part::Material steel(double poissons_ratio = 0.3) {
  return {"steel", 210e9, poissons_ratio, 7850.0, 355e6};
}

MatrixXd displacements(const auto& basis) {
  return basis.columns * basis.coefficients;
}

/// Largest difference of the displacements over the largest [1].
double distance(const MatrixXd& a, const MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// The same problem by both engines.
template <int dim>
struct Pair {
  DisplacementBasis<dim> own, dealii;
};
template <int dim>
Pair<dim> solve_twice(ElasticProblem<dim> problem, int degree) {
  problem.engine = Engine::kOwn;
  auto own = solve<dim>(problem, degree);
  problem.engine = Engine::kDealii;
  return {std::move(own), solve<dim>(problem, degree)};
}

template <int dim>
void expect_agreement(const ElasticProblem<dim>& problem, int degree) {
  const auto [own, dealii] = solve_twice<dim>(problem, degree);
  EXPECT_EQ(dealii.engine.engine, Engine::kDealii);
  EXPECT_LT(distance(displacements(dealii), displacements(own)), kAgreement)
      << dim << "-D, degree " << degree;
  EXPECT_LT((dealii.strain_energy - own.strain_energy).norm(),
            kAgreement * own.strain_energy.norm());
}

loads::LoadHistory traction_on(const std::string& group, const Vector3d& t,
                               double area, const Vector3d& centroid) {
  loads::InstantLoad load;
  load.label = "case";
  loads::SurfaceLoad surface{.group = group, .resultant = {}};
  surface.traction = t;
  surface.resultant = {.force = area * t, .moment = centroid.cross(area * t)};
  surface.total = area * t.norm();
  load.surface_loads = {surface};
  return {{}, {load}};
}

mesh::PartMesh<3> block() {
  return support::structured_mesh<3>(
      {3, 2, 2}, 1, [](const Vector3d& x) -> Vector3d {
        return {0.06 * x[0] * (1.0 + 0.1 * x[1]), 0.02 * x[1],
                0.015 * x[2] * (1.0 + 0.2 * x[0])};
      });
}

TEST(DealiiSolver, FreeRingOfEveryDegree) {
  // Free, with pins, folded at its mirrors, curved cells; several instants.
  const auto eye = support::eye_problem(5, 3);
  for (int degree = 1; degree <= 5; ++degree) {
    expect_agreement<3>(eye.problem(), degree);
  }
}

TEST(DealiiSolver, ClampedBlockOfEveryDegree) {
  const auto mesh = block();
  const auto history = traction_on("x1", {0.0, -1e6, 4e5}, 0.02 * 0.015 * 1.2,
                                   {0.06, 0.01, 0.009});
  const auto material = steel(0.45);
  for (int degree = 1; degree <= 6; ++degree) {
    expect_agreement<3>(
        {mesh, material, history, {{"x0", {true, true, true}}}, "block"},
        degree);
  }
}

TEST(DealiiSolver, HeldInSomeDirectionsOnly) {
  const auto mesh = block();
  const auto history = traction_on("x1", {1e6, -1e6, 4e5}, 0.02 * 0.015 * 1.2,
                                   {0.06, 0.01, 0.009});
  const auto material = steel();
  expect_agreement<3>({mesh,
                       material,
                       history,
                       {{"x0", {true, false, false}},
                        {"y0", {false, true, false}},
                        {"z0", {false, false, true}}},
                       "block"},
                      3);
}

TEST(DealiiSolver, PlaneStressOfEveryDegree) {
  auto mesh =
      support::structured_mesh<2>({4, 3}, 2, [](const Vector2d& x) -> Vector2d {
        const double r = 0.02 + 0.01 * x[0];
        const double angle = 1.2 * x[1];
        return {r * std::cos(angle), r * std::sin(angle)};
      });
  mesh.thickness = 0.004;
  const auto history =
      traction_on("x1", {2e6, 1e6, 0.0}, 0.03 * 1.2 * 0.004, {0.02, 0.02, 0.0});
  const auto material = steel();
  for (int degree = 1; degree <= 6; ++degree) {
    expect_agreement<2>(
        {mesh, material, history, {{"y0", {true, true, false}}}, "plate"},
        degree);
  }
}

TEST(DealiiSolver, ElasticBeds) {
  const auto mesh = block();
  const auto history = traction_on("z1", {1e5, 0.0, -2e6}, 0.06 * 0.02 * 1.05,
                                   {0.03, 0.01, 0.015});
  const auto material = steel();
  const part::Foundations beds{{"z0", {.normal = 4e10, .tangential = 9e9}}};
  for (int degree = 1; degree <= 4; ++degree) {
    ElasticProblem<3> problem{mesh, material, history, {}, "block"};
    problem.foundations = beds;
    expect_agreement<3>(problem, degree);  // the bed alone holds it
    problem.fixed = {{"x0", {true, true, true}}};
    expect_agreement<3>(problem, degree);
  }
}

TEST(DealiiSolver, SeesPlantedFaults) {
  // What agrees to 1e-9 shows a modulus that is off by 1e-7, and geometry of
  // a lower degree.
  const auto eye = support::eye_problem(2, 3);
  auto problem = eye.problem();
  problem.engine = Engine::kOwn;
  const auto own = solve<3>(problem, 3);
  auto softer = eye;
  softer.material.youngs_modulus *= 1.0 - 1e-7;
  problem.engine = Engine::kDealii;
  const auto off = solve<3>({softer.mesh,
                             softer.material,
                             softer.history,
                             {},
                             "eye",
                             LinearSolver::kAuto,
                             {},
                             Engine::kDealii},
                            3);
  EXPECT_GT(distance(displacements(off), displacements(own)), 20 * kAgreement);
  const auto coarser = support::eye_problem(2, 2);
  auto other = coarser.problem();
  other.engine = Engine::kDealii;
  EXPECT_GT(distance(displacements(solve<3>(other, 3)), displacements(own)),
            20 * kAgreement);
}

TEST(DealiiSolver, ChecksAreThoseOfOurKernels) {
  const auto eye = support::eye_problem(3, 3);
  const auto [own, dealii] = solve_twice<3>(eye.problem(), 3);
  EXPECT_LT(dealii.checks.residual, 1e-9);
  EXPECT_LT(dealii.checks.equilibrium, 1e-9);
  EXPECT_LT(dealii.checks.energy, 1e-10);
}

/// Of a solve whose solution is known.
struct KnownSolve {
  double error{};  ///< largest over the largest displacement [1]
  int iterations{};
};

/// Loads that are K times noise, with a coarsest level that is factored or not.
KnownSolve solve_noise(const Discretization<3>& part,
                       const std::vector<int>& held,
                       double most_factored = kMostFactored) {
  const auto material = steel();
  const auto stiffness = assemble_stiffness(part, material, "bar");
  MatrixXd truth = MatrixXd::Random(part.dofs(), 1);
  for (const int dof : held) truth(dof, 0) = 0.0;
  const FoundationStiffness<3> none(part, {}, "bar");
  DealiiSolver<3> solver(part, material, none, held, "bar", false,
                         most_factored);
  const MatrixXd found = solver.solve(stiffness.multiply(truth));
  return {distance(found, truth), solver.report().iterations};
}

TEST(DealiiSolver, CoarsestLevelByAlgebraicMultigrid) {
  const auto mesh = support::structured_mesh<3>(
      {24, 3, 3}, 1, [](const Vector3d& x) -> Vector3d {
        return {0.3 * x[0], 0.02 * x[1], 0.015 * x[2] * (1.0 + 0.2 * x[0])};
      });
  const auto part = discretize<3>(mesh, 3);
  const auto clamped = held_on_groups<3>(part, {{"x0", {true, true, true}}});
  const auto free = determinate_supports<3>(part, node_positions(part));
  for (const auto& held : {clamped, free}) {
    for (const double most_factored : {kMostFactored, 0.0}) {
      const auto result = solve_noise(part, held, most_factored);
      EXPECT_LT(result.error, kAgreement);
      EXPECT_LT(result.iterations, 25);
    }
  }
}

TEST(DealiiSolver, LongCellsTakeFewIterations) {
  for (const double aspect : {1.0, 4.0, 10.0}) {
    const auto mesh = support::structured_mesh<3>(
        {6, 6, 6}, 1, [&](const Vector3d& x) -> Vector3d {
          return {0.1 * aspect * x[0], 0.1 * x[1], 0.1 * x[2]};
        });
    const auto part = discretize<3>(mesh, 3);
    const auto result = solve_noise(
        part, held_on_groups<3>(part, {{"x0", {true, true, true}}}));
    EXPECT_LT(result.error, kAgreement) << "cells 1:" << aspect;
    EXPECT_LE(result.iterations, 22) << "cells 1:" << aspect;
  }
}

TEST(DealiiSolver, RefusesSimplices) {
  const auto mesh =
      support::simplex_mesh<3>({1, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return x;
      });
  const auto history = traction_on("x1", {1e6, 0, 0}, 1.0, {1.0, 0.5, 0.5});
  const auto material = steel();
  ElasticProblem<3> problem{
      mesh, material, history, {{"x0", {true, true, true}}}, "tets"};
  problem.engine = Engine::kDealii;
  try {
    solve<3>(problem, 2);
    FAIL() << "not refused";
  } catch (const Error& refused) {
    EXPECT_EQ(refused.code(), "F005");
    EXPECT_EQ(refused.place(), "part tets");
  }
}

TEST(LevelDegrees, FallToWhatIsFactored) {
  using Degrees = std::vector<int>;
  EXPECT_EQ(level_degrees(1, 3, 1e3), (Degrees{1}));
  EXPECT_EQ(level_degrees(2, 3, 1e3), (Degrees{2}));
  EXPECT_EQ(level_degrees(4, 3, 1e4), (Degrees{4, 2}));
  EXPECT_EQ(level_degrees(5, 2, 1e4), (Degrees{5, 4, 2}));
  EXPECT_EQ(level_degrees(3, 3, 1e6), (Degrees{3, 2, 1}));
  EXPECT_EQ(level_degrees(6, 3, 1e4), (Degrees{6, 3, 2}));
}

}  // namespace
}  // namespace clevis::elasticity
