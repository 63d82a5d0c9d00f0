// Mirror planes are found where they are and nowhere else, and a part solved
// on one side of them moves as it does solved whole.

#include "elasticity/mirror_symmetry/folding.h"

#include <gtest/gtest.h>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/solid/solid_solve.h"
#include "part/supports.h"
#include "support/elastic_field_problem.h"
#include "support/eye_problem.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;

mesh::PartMesh<3> block(std::array<int, 3> divisions, double skew = 0.0) {
  return support::structured_mesh<3>(
      divisions, 2, [skew](const Vector3d& x) -> Vector3d {
        return {0.2 * x[0] + skew * x[0] * x[0] * x[1], 0.1 * x[1],
                0.05 * x[2] + 0.01};
      });
}

/// Axes of the mirrors of a mesh.
std::vector<int> axes(const mesh::PartMesh<3>& mesh, int degree = 2) {
  const auto discretization = discretize<3>(mesh, degree);
  std::vector<int> result;
  for (const auto& mirror :
       find_mirrors<3>(discretization, node_positions(discretization))) {
    result.push_back(mirror.axis);
  }
  return result;
}

TEST(Mirror, FindsThePlanesOfABlock) {
  EXPECT_EQ(axes(block({2, 4, 2})), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(axes(block({2, 4, 2}), 3), (std::vector<int>{0, 1, 2}));
}

TEST(Mirror, CellsAcrossThePlaneForbidIt) {
  EXPECT_EQ(axes(block({3, 2, 2})), (std::vector<int>{1, 2}));
}

TEST(Mirror, NearlySymmetricIsNotSymmetric) {
  EXPECT_EQ(axes(block({2, 2, 2}, 1e-6 * 0.2)), std::vector<int>{2});
}

TEST(Mirror, OfAPlaneMesh) {
  const auto mesh = support::structured_mesh<2>(
      {4, 2}, 1, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
        return {x[0], x[1] * (1.0 + 0.3 * x[0])};
      });
  const auto discretization = discretize<2>(mesh, 3);
  EXPECT_TRUE(
      find_mirrors<2>(discretization, node_positions(discretization)).empty());
  const auto straight = support::structured_mesh<2>(
      {4, 2}, 1, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
        return {x[0], x[1]};
      });
  const auto plane = discretize<2>(straight, 3);
  EXPECT_EQ(find_mirrors<2>(plane, node_positions(plane)).size(), 2U);
}

TEST(Folding, EveryRigidModeBelongsToOneClass) {
  const auto discretization = discretize<3>(block({2, 2, 2}), 1);
  const auto positions = node_positions(discretization);
  const auto folding = fold<3>(discretization, positions,
                               find_mirrors<3>(discretization, positions));
  EXPECT_EQ(folding.part.cells(), 1);
  const auto modes = rigid_modes<3>(positions, Vector3d(0.1, 0.05, 0.035), 1.0);
  const auto folded_modes = rigid_modes<3>(node_positions(folding.part),
                                           Vector3d(0.1, 0.05, 0.035), 1.0);
  std::vector<int> found;
  for (unsigned parity = 0; parity < folding.classes(); ++parity) {
    for (int mode : rigid_modes_of(folding, parity)) {
      found.push_back(mode);
      Eigen::MatrixXd rest = -modes.col(mode);
      add_unfolded<3>(folding, parity, folded_modes.col(mode), rest);
      EXPECT_LT(rest.norm(), 1e-14);
    }
  }
  std::ranges::sort(found);
  EXPECT_EQ(found, (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

void expect_same_as_whole(const ElasticProblem<3>& problem) {
  const auto folded = solve<3>(problem, 2);
  const auto whole = support::solve_field<3>(problem, {}, 2);
  const Eigen::MatrixXd u = folded.columns * folded.coefficients.col(0);
  EXPECT_LT((u - whole.columns).norm(), 1e-9 * whole.columns.norm());
}

loads::LoadHistory traction(const Vector3d& direction) {
  loads::SurfaceLoad load;
  load.group = "x1";
  load.traction = 1e6 * direction;
  load.resultant.force = 0.1 * 0.05 * load.traction;
  load.resultant.moment =
      Vector3d(0.2, 0.05, 0.035).cross(load.resultant.force);
  loads::LoadHistory history;
  history.instants.resize(1);
  history.instants[0].surface_loads = {load};
  return history;
}

// A clamp at one end leaves two mirrors; a skew pull has three classes.
TEST(Folding, ClampedBlockMovesAsTheWhole) {
  const auto mesh = block({4, 2, 2});
  const part::Material material{"steel", 210e9, 0.3, 7850.0, 355e6};
  const part::Supports clamp = {{"x0", {true, true, true}}};
  const auto along = traction({1, 0, 0});
  expect_same_as_whole({mesh, material, along, clamp, "P"});
  const auto skew = traction({1, -2, 0.5});
  expect_same_as_whole({mesh, material, skew, clamp, "P"});
}

// A support that is not its own image leaves no mirror.
TEST(Folding, SupportsOfOneSideUnfoldTheMesh) {
  const auto mesh = block({4, 2, 2});
  const part::Material material{"steel", 210e9, 0.3, 7850.0, 355e6};
  const auto skew = traction({1, -2, 0.5});
  expect_same_as_whole({mesh,
                        material,
                        skew,
                        {{"x0", {true, false, false}},
                         {"y0", {false, true, false}},
                         {"z0", {false, false, true}}},
                        "P"});
}

/// Supports of a free block in shear, over its load; its mid-plane y = const is
/// bent by `offset` [m] in the middle of the length.
double support_of_sheared_block(double offset) {
  const auto mesh = support::structured_mesh<3>(
      {4, 4, 2}, 2, [offset](const Vector3d& x) -> Vector3d {
        const double middle = 16.0 * x[0] * (1.0 - x[0]) * x[1] * (1.0 - x[1]);
        return {0.2 * x[0], 0.1 * x[1] + offset * middle, 0.05 * x[2]};
      });
  EXPECT_EQ(axes(mesh), (std::vector<int>{0, 1, 2}));
  const part::Material material{"steel", 210e9, 0.3, 7850.0, 355e6};
  loads::LoadHistory history;
  history.seats.resize(2);
  history.instants.resize(1);
  history.instants[0].wrenches.resize(2);
  for (std::size_t s = 0; s < 2; ++s) {
    const double sign = s == 0 ? -1.0 : 1.0;
    history.seats[s].name = history.seats[s].group = s == 0 ? "x0" : "x1";
    history.seats[s].kind = loads::SeatKind::kTraction;
    history.seats[s].p_LS = Vector3d(0.1 + sign * 0.1, 0.05, 0.025);
    history.instants[0].wrenches[s] = {{0.0, sign * 1.0, 0.0},
                                       {0.0, 0.0, -0.1}};
  }
  return solve<3>({mesh, material, history, {}, "P"}, 2).checks.equilibrium;
}

// Within the tolerance of a mirror a mesh may miss its plane; forces that a
// class takes there have no arm by that, and leave nothing to the supports of a
// free part.
TEST(Folding, SupportsOfAFreePartTakeNothingWhereThePlaneIsMissed) {
  const double size = Vector3d(0.2, 0.1, 0.05).norm();
  constexpr double kRoundOff = 1e-11;
  EXPECT_LT(support_of_sheared_block(0.0), kRoundOff);
  EXPECT_LT(support_of_sheared_block(0.45e-9 * size), kRoundOff);
}

}  // namespace
}  // namespace clevis::elasticity
