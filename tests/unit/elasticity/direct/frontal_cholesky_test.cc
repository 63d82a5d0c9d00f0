// The fronts cover a matrix whatever is held and however it is numbered, and
// solve what CHOLMOD solves.

#include "elasticity/direct/frontal_cholesky.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

template <int dim>
struct System {
  Dissection dissection;
  EquationNumbers numbers;
  StiffnessMatrix<dim> stiffness;
  UpperTriangle matrix;
  FrontTree tree() const {
    return front_tree(dissection, dim, numbers.equation);
  }
};

/// A skewed block, held where x = 0.
template <int dim>
System<dim> block(std::array<int, dim> cells, int degree, bool renumber) {
  using Vector = Eigen::Matrix<double, dim, 1>;
  const auto mesh =
      support::structured_mesh<dim>(cells, 1, [](const Vector& x) -> Vector {
        Vector y = x;
        y[0] += 0.2 * x[1] * x[0];
        return y;
      });
  auto part = discretize<dim>(mesh, degree);
  part.thickness = 1.0;
  System<dim> system;
  std::vector<int> place;
  system.dissection =
      renumber ? dissect_and_renumber<dim>(part, place) : dissect<dim>(part);
  const auto held = fixed_supports<dim>(part, node_positions<dim>(part),
                                        {{"x0", {true, true, true}}}, "block");
  system.numbers = number_equations(part.dofs(), held);
  system.stiffness = assemble_stiffness<dim>(part, kSteel, "block");
  system.matrix = free_equations(system.stiffness, system.numbers);
  return system;
}

template <int dim>
void expect_as_by_cholmod(const System<dim>& system) {
  const FrontalCholesky fronts(system.matrix, system.tree(), "block");
  const FrontalCholesky by_rows(free_rows(system.stiffness, system.numbers),
                                system.tree(), "block", 2);
  const SparseCholesky cholmod(system.matrix, "block");
  const MatrixXd b = MatrixXd::Random(system.matrix.rows(), 5);
  const MatrixXd expected = cholmod.solve(b);
  EXPECT_LT((fronts.solve(b) - expected).norm(), 1e-11 * expected.norm());
  EXPECT_EQ(by_rows.solve(b), fronts.solve(b));
}

TEST(FrontalCholesky, SolvesWhatCholmodSolves) {
  for (const bool renumber : {false, true}) {
    for (const int degree : {1, 2, 4}) {
      expect_as_by_cholmod(block<2>({9, 5}, degree, renumber));
      expect_as_by_cholmod(block<2>({1, 1}, degree, renumber));
    }
    for (const int degree : {1, 2, 3}) {
      expect_as_by_cholmod(block<3>({5, 3, 2}, degree, renumber));
    }
  }
}

TEST(FrontalCholesky, HalvesOfTheSolutionHaveTheEnergyAsTheirSquare) {
  const auto system = block<3>({5, 3, 2}, 2, false);
  const FrontalCholesky fronts(system.matrix, system.tree(), "block");
  const FrontalCholesky by_rows(free_rows(system.stiffness, system.numbers),
                                system.tree(), "block", 2);
  const SparseCholesky cholmod(system.matrix, "block");
  const MatrixXd b = MatrixXd::Random(system.matrix.rows(), 3);
  const MatrixXd x = cholmod.solve(b);
  const MatrixXd y = fronts.solve_lower(b);
  const MatrixXd energy = b.transpose() * x;
  EXPECT_LT((y.transpose() * y - energy).norm(), 1e-11 * energy.norm());
  EXPECT_LT((fronts.solve_upper(y) - x).norm(), 1e-11 * x.norm());
}

TEST(FrontalCholesky, EveryUnknownIsEliminatedOnceAndEveryBorderTakenOver) {
  const auto system = block<3>({5, 4, 3}, 2, false);
  const FrontTree tree = system.tree();
  int next = 0;
  std::vector<const Front*> waiting;
  for (const Front& front : tree.fronts) {
    EXPECT_EQ(front.begin, next);
    next = front.end;
    EXPECT_TRUE(std::ranges::is_sorted(front.border));
    for (int child = 0; child < front.children; ++child) {
      for (const int unknown : waiting.back()->border) {
        EXPECT_TRUE(unknown < front.end
                        ? unknown >= front.begin
                        : std::ranges::binary_search(front.border, unknown));
      }
      waiting.pop_back();
    }
    waiting.push_back(&front);
  }
  EXPECT_EQ(next, system.numbers.count);
  ASSERT_EQ(waiting.size(), 1u);
  EXPECT_TRUE(waiting[0]->border.empty());
  EXPECT_GT(tree.fronts.size(), 10u);
  std::vector<int> places = tree.place;
  std::ranges::sort(places);
  std::vector<int> all(places.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(places, all);
}

TEST(FrontalCholesky, RefusesWhatIsNotPositiveDefinite) {
  auto system = block<2>({6, 4}, 2, false);
  const auto row = static_cast<std::size_t>(system.matrix.rows() / 2);
  system.matrix.value[static_cast<std::size_t>(system.matrix.row_start[row])] *=
      -1.0;
  try {
    const FrontalCholesky factor(system.matrix, system.tree(), "part X");
    FAIL() << "factored";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F002");
  }
}

TEST(FrontalCholesky, NoColumnsAreSolvedToNone) {
  const auto system = block<2>({3, 2}, 1, true);
  const FrontalCholesky factor(system.matrix, system.tree(), "block");
  EXPECT_EQ(factor.solve(MatrixXd(system.matrix.rows(), 0)).cols(), 0);
}

TEST(FrontalCholesky, TheSameBitsTwice) {
  const auto system = block<3>({4, 3, 3}, 2, true);
  const MatrixXd b = MatrixXd::Random(system.matrix.rows(), 3);
  const FrontalCholesky one(system.matrix, system.tree(), "block");
  const FrontalCholesky two(system.matrix, system.tree(), "block");
  EXPECT_EQ(one.solve(b), two.solve(b));
}

/// Fronts that are worked on in blocks, and subtrees for several threads.
System<3> large_block() {
  return block<3>({7, 6, 6}, 3, true);
}

TEST(FrontalCholesky, TheSameBitsByAnyNumberOfThreads) {
  for (const auto& system : {large_block(), block<3>({2, 1, 1}, 2, false)}) {
    const MatrixXd b = MatrixXd::Random(system.matrix.rows(), 2);
    const FrontalCholesky one(system.matrix, system.tree(), "block");
    const MatrixXd expected = one.solve(b);
    for (const int threads : {2, 3, 8}) {
      const FrontalCholesky many(system.matrix, system.tree(), "block",
                                 threads);
      EXPECT_EQ(many.solve(b), expected) << threads;
    }
  }
}

TEST(FrontalCholesky, BlocksOfLargeFrontsSolveWhatCholmodSolves) {
  const auto system = large_block();
  const auto tree = system.tree();
  EXPECT_TRUE(std::ranges::any_of(tree.fronts, [](const Front& front) {
    return front.own() > 256 && front.later() > 512;  // several blocks
  }));
  expect_as_by_cholmod(system);
}

TEST(FrontalCholesky, ThreadsRefuseWhatIsNotPositiveDefinite) {
  for (const int share : {2, 50}) {  // above all subtrees, and in one of them
    auto system = large_block();
    const auto row = static_cast<std::size_t>(system.matrix.rows() / share);
    system.matrix
        .value[static_cast<std::size_t>(system.matrix.row_start[row])] *= -1.0;
    EXPECT_THROW(FrontalCholesky(system.matrix, system.tree(), "part X", 2),
                 Error);
  }
}

TEST(FrontalCholesky, FloatsHoldSevenDigits) {
  const auto system = large_block();
  const MatrixXd b = MatrixXd::Random(system.matrix.rows(), 2);
  const MatrixXd expected =
      FrontalCholesky(system.matrix, system.tree(), "block").solve(b);
  const FrontalFactor<float> single(system.matrix, system.tree(), "block", 2);
  const double error = (single.solve(b) - expected).norm() / expected.norm();
  EXPECT_LT(error, 1e-3);
  EXPECT_GT(error, 1e-10);
}

}  // namespace
}  // namespace clevis::elasticity
