// Triangles and tetrahedra beside quadrangles and hexahedra: what either costs
// for the same error of a known stress. The printed lines "shapes, ..." are a
// table of results/studies/accuracy.

#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "support/nafems_plates.h"
#include "support/ring_problems.h"

namespace clevis {
namespace {

using mesh::CellShape;
using support::Cells;
using support::Measured;

using Problem = std::function<Measured(const Cells&)>;

/// What an error costs [1].
struct Cost {
  double dofs{}, flops{};
};

/// Cells along a side of one mesh after the other, until the error is below
/// the one that is wanted; the cost of that one by the power law between the
/// last two.
Cost cost_of(const Problem& problem, CellShape shape, double error) {
  constexpr int kMost = 16;
  Measured before;
  for (int n = 1; n <= kMost; ++n) {
    const Measured here = problem({n, shape});
    if (here.error <= error && n > 1) {
      const double share =
          std::log(before.error / error) / std::log(before.error / here.error);
      const auto between = [&](double a, double b) {
        return a * std::pow(b / a, share);
      };
      return {between(before.dofs, here.dofs),
              between(before.flops, here.flops)};
    }
    before = here;
  }
  ADD_FAILURE() << "not within " << error;
  return {1.0, 1.0};
}

/// @param most  of the ratio of unknowns: two or six simplices fill a cell of
///   the other kind.
void compare(const char* name, const Problem& problem, double error,
             double most) {
  const Cost tensor = cost_of(problem, CellShape::kTensor, error);
  const Cost simplex = cost_of(problem, CellShape::kSimplex, error);
  std::printf("shapes, %s, %.0e, %.0f, %.0f, %.2f, %.2f\n", name, error,
              tensor.dofs, simplex.dofs, simplex.dofs / tensor.dofs,
              simplex.flops / tensor.flops);
  EXPECT_LE(simplex.dofs, most * tensor.dofs) << name;
}

constexpr double kOfTriangles = 4.0, kOfTetrahedra = 8.0;

TEST(CellShapes, Kirsch) {
  compare("Kirsch; plane stress", support::kirsch<2>, 1e-4, kOfTriangles);
  compare("Kirsch; plane strain in 3-D", support::kirsch<3>, 1e-3,
          kOfTetrahedra);
}

TEST(CellShapes, Lame) {
  const auto lame = [](auto solve) {
    return [solve](const Cells& cells) {
      return solve(cells, 0.3);
    };
  };
  compare("Lamé; plane stress", lame(support::lame<2>), 1e-4, kOfTriangles);
  compare("Lamé; plane strain in 3-D", lame(support::lame<3>), 1e-4,
          kOfTetrahedra);
}

TEST(CellShapes, SpinningRing) {
  compare("spinning ring; plane stress", support::spinning<2>, 1e-4,
          kOfTriangles);
  compare("spinning tube; plane strain in 3-D", support::spinning<3>, 1e-3,
          kOfTetrahedra);
}

/// Against the finest quadrangles: the published value has three digits.
TEST(CellShapes, NafemsLe1) {
  const auto solved = [](const Cells& cells) {
    return support::solve_le1(
        support::elliptic_quarter<2>({cells.number, cells.number}, cells.shape),
        cells.degree);
  };
  const auto stress = [](const elasticity::DisplacementBasis<2>& basis) {
    return support::stress_yy_at<2>(basis, {2.0, 0.0});
  };
  const double exact = stress(solved({24}));
  EXPECT_NEAR(exact, 92.7e6, 0.001 * 92.7e6);
  compare(
      "NAFEMS LE1",
      [&](const Cells& cells) {
        const auto basis = solved(cells);
        return Measured{basis.discretization.dofs(),
                        std::abs(stress(basis) / exact - 1.0),
                        support::factor_flops(basis.discretization)};
      },
      1e-4, kOfTriangles);
}

TEST(CellShapes, NafemsLe10) {
  const auto solved = [](const Cells& cells) {
    return support::solve_le10(
        support::elliptic_quarter<3>({cells.number, cells.number, 2},
                                     cells.shape),
        cells.degree);
  };
  const auto stress = [](const elasticity::DisplacementBasis<3>& basis) {
    return support::stress_yy_at<3>(basis, {2.0, 0.0, 0.3});
  };
  constexpr double kPublished = -5.38e6;
  compare(
      "NAFEMS LE10",
      [&](const Cells& cells) {
        const auto basis = solved(cells);
        return Measured{basis.discretization.dofs(),
                        std::abs(stress(basis) / kPublished - 1.0),
                        support::factor_flops(basis.discretization)};
      },
      5e-3, kOfTetrahedra);
}

}  // namespace
}  // namespace clevis
