// What several processors work out together is, bit by bit, what one does.

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/system/processor_share.h"
#include "elasticity/algebra/even_runs.h"
#include "stress/field/stress_history.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

/// Has this process keep so many processors busy until it ends.
class Processors {
 public:
  explicit Processors(int count) { share_processors(count, one_process()); }
  ~Processors() { share_processors(1, one_process()); }
  Processors(const Processors&) = delete;
  Processors& operator=(const Processors&) = delete;

 private:
  static const SharedCount& one_process() {
    static const SharedCount count(1);
    return count;
  }
};

TEST(EvenRuns, CoverAllOnceAndInOrder) {
  using Run = std::pair<std::ptrdiff_t, std::ptrdiff_t>;
  const auto runs = [](std::ptrdiff_t count, std::ptrdiff_t least) {
    return elasticity::in_even_runs(count, least,
                                    [](std::ptrdiff_t from, std::ptrdiff_t to) {
                                      return Run(from, to);
                                    });
  };
  EXPECT_EQ(runs(10, 1), (std::vector<Run>{{0, 10}}));
  const Processors three(3);
  EXPECT_EQ(runs(10, 1), (std::vector<Run>{{0, 3}, {3, 6}, {6, 10}}));
  EXPECT_EQ(runs(10, 5), (std::vector<Run>{{0, 5}, {5, 10}}));
  EXPECT_EQ(runs(10, 6), (std::vector<Run>{{0, 10}}));
  EXPECT_EQ(runs(0, 1), (std::vector<Run>{{0, 0}}));
}

TEST(EvenRuns, ThrowWhatAnyOfThemThrows) {
  const Processors two(2);
  for (const int bad : {0, 1}) {
    EXPECT_THROW(
        elasticity::in_even_runs(2, 1,
                                 [bad](std::ptrdiff_t from, std::ptrdiff_t) {
                                   if (from == bad)
                                     throw std::runtime_error("a run");
                                   return true;
                                 }),
        std::runtime_error);
  }
}

/// A block of cells that are all askew.
mesh::PartMesh<3> block(mesh::CellShape shape) {
  const auto askew = [](const Vector3d& x) -> Vector3d {
    return {x[0] + 0.05 * x[1] * x[2], x[1] + 0.04 * x[0] * x[0],
            x[2] - 0.03 * x[0] * x[1]};
  };
  return shape == mesh::CellShape::kTensor
             ? support::structured_mesh<3>({7, 5, 4}, 2, askew)
             : support::simplex_mesh<3>({4, 3, 3}, 2, askew);
}

void expect_same_by_three(mesh::CellShape shape, int degree,
                          Eigen::Index instants) {
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = elasticity::discretize<3>(block(shape), degree);
  // Stresses that differ from cell to cell and grow to and fro in time.
  const Eigen::Index dofs = basis.discretization.dofs();
  basis.columns.resize(dofs, 3);
  for (Eigen::Index i = 0; i < dofs; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      basis.columns(i, k) =
          1e-6 * std::sin(0.7 * double(i * (k + 1)) + double(k));
    }
  }
  basis.coefficients.resize(3, instants);
  for (Eigen::Index i = 0; i < instants; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      basis.coefficients(k, i) = std::cos(0.3 * double(i * (k + 1)));
    }
  }
  const StressHistory history = stress_history<3>(basis, steel, 4);
  const Processors three(3);
  const StressHistory history_by_three = stress_history<3>(basis, steel, 4);
  EXPECT_EQ(history.worst, history_by_three.worst);
  EXPECT_EQ(history.worst_instant, history_by_three.worst_instant);
  EXPECT_EQ(history.peak, history_by_three.peak);
  EXPECT_EQ(history.peak_instant, history_by_three.peak_instant);
  EXPECT_EQ(history.peak_at.cell, history_by_three.peak_at.cell);
  EXPECT_EQ(history.peak_at.point, history_by_three.peak_at.point);
  EXPECT_EQ(history.sampling_error, history_by_three.sampling_error);
}

TEST(Processors, LeaveHexahedraAsTheyAre) {
  expect_same_by_three(mesh::CellShape::kTensor, 3, 2);
}

TEST(Processors, LeaveTetrahedraAsTheyAre) {
  expect_same_by_three(mesh::CellShape::kSimplex, 2, 3);
}

// So many that floats look for the largest.
TEST(Processors, LeaveManyInstantsAsTheyAre) {
  expect_same_by_three(mesh::CellShape::kSimplex, 3, 300);
}

}  // namespace
}  // namespace clevis::stress
