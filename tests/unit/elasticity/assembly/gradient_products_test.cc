#include "elasticity/assembly/gradient_products.h"

#include <cmath>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/problem/refinement.h"
#include "support/structured_mesh.h"

namespace {

using namespace clevis;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// Curved cells, no two edges alike: the forces by K are those by the strains at
// the points of the rule, an independent way, whatever the degree.
TEST(GradientProducts, OfCurvedHexahedraGiveTheForcesOfTheStrains) {
  constexpr double kRoundOff = 1e-11;
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  const auto mesh =
      support::structured_mesh<3>({2, 1, 1}, 3, [](const Vector3d& x) {
        return Vector3d(0.03 * x[0] + 0.004 * x[1] * x[2],
                        0.02 * x[1] + 0.003 * std::sin(2.0 * x[0]),
                        0.01 * x[2] + 0.002 * x[0] * x[1] * x[1]);
      });
  for (const int degree : {1, 2, 3, 4, 6}) {
    const auto part = elasticity::discretize<3>(mesh, degree);
    const MatrixXd u = MatrixXd::Random(part.dofs(), 3);
    const MatrixXd forces =
        elasticity::assemble_stiffness<3>(part, steel, "part").multiply(u);
    const MatrixXd expected = elasticity::forces_by_strain<3>(part, steel, u);
    EXPECT_LE((forces - expected).norm(), kRoundOff * expected.norm())
        << "degree " << degree;
    EXPECT_GT(expected.norm(), 0.0);
  }
}

}  // namespace
