#include "elasticity/solid/neighbourhood.h"

#include <gtest/gtest.h>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "support/eye_problem.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

/// An eye solved with degree 2, and its load with degree 4.
struct SolvedEye {
  support::EyeProblem eye = support::eye_problem(1);
  DisplacementBasis<3> coarse = solve<3>(eye.problem(), 2);
  Discretization<3> fine = discretize<3>(eye.mesh, 3);
  MatrixXd load =
      assemble_loads<3>(fine, eye.history, eye.material.density, "");
  MatrixXd displacement = coarse.columns * coarse.coefficients;

  Enriched<3> enriched(const std::vector<int>& centre) const {
    return enrich<3>(
        {coarse.discretization, displacement, fine, load, {}, eye.material},
        with_neighbours<3>(fine, centre));
  }
};

double energy(const DisplacementBasis<3>& basis, const part::Material& steel) {
  const MatrixXd u = basis.columns * basis.coefficients;
  const auto stiffness =
      assemble_stiffness<3>(basis.discretization, steel, "test");
  return 0.5 * u.col(0).dot(stiffness.multiply(u).col(0));
}

// A neighbourhood that is the whole part leaves nothing of the lower degree.
TEST(Neighbourhood, OfAllCellsIsTheHigherDegreesSolution) {
  const SolvedEye solved;
  const auto enriched = solved.enriched({0, 2, 4, 6});
  ASSERT_EQ(enriched.cells.size(), solved.fine.cell_nodes.size());
  const auto whole = solve<3>(solved.eye.problem(), 3);
  const double wanted = energy(whole, solved.eye.material);
  EXPECT_NEAR(energy(enriched.basis, solved.eye.material), wanted,
              1e-6 * wanted);
  EXPECT_GT(wanted - energy(solved.coarse, solved.eye.material), 1e-4 * wanted);
}

// Of one cell: it and both its neighbours, whose far sides keep what they had.
TEST(Neighbourhood, KeepsTheDisplacementOnItsBorder) {
  const SolvedEye solved;
  const auto enriched = solved.enriched({3});
  EXPECT_EQ(enriched.cells, (std::vector<int>{2, 3, 4}));
  const auto& part = enriched.basis.discretization;
  const auto corner = [&](const Discretization<3>& d, const MatrixXd& u,
                          std::size_t cell, int vertex) {
    // FE_Q numbers the vertices of a cell first.
    return Eigen::Vector3d(u.block<3, 1>(
        3 * d.cell_nodes[cell][static_cast<std::size_t>(vertex)], 0));
  };
  int kept = 0;
  int moved = 0;
  for (int v = 0; v < 8; ++v) {
    for (const std::size_t k : {0U, 2U}) {
      const double change =
          (corner(part, enriched.basis.columns, k, v) -
           corner(solved.coarse.discretization, solved.displacement,
                  static_cast<std::size_t>(enriched.cells[k]), v))
              .norm();
      (change < 1e-18 ? kept : moved) += 1;
    }
  }
  EXPECT_EQ(kept, 8);
  EXPECT_EQ(moved, 8);
}

}  // namespace
}  // namespace clevis::elasticity
