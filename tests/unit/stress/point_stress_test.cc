#include "stress/many_instants/point_stress.h"

#include <cmath>

#include <gtest/gtest.h>

#include "elasticity/assembly/supports.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

const part::Material kSteel{"steel", 200e9, 0.0, 7850.0, 300e6};

// Simple shear u_x = γ y beside bending u_x = −κ x y, u_y = κ x²/2: at ν = 0
// σ_xx = −E κ y and τ = G γ, so von Mises = √(σ² + 3 τ²) of any combination.
TEST(PointStress, IsThatOfEveryCombination) {
  const auto mesh =
      support::structured_mesh<3>({2, 1, 1}, 1, [](const Vector3d& x) {
        return x;
      });
  const auto cube = elasticity::discretize<3>(mesh, 2);
  const auto at = elasticity::node_positions(cube);
  MatrixXd columns = MatrixXd::Zero(cube.dofs(), 2);
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    const double x = at(0, i), y = at(1, i);
    columns(3 * i, 0) = 1e-3 * y;
    columns(3 * i, 1) = -1e-3 * x * y;
    columns(3 * i + 1, 1) = 0.5e-3 * x * x;
  }
  // corners of the lattice of one interval: y = 0 and y = 1, in both cells
  const std::vector<FieldPoint> points{{0, 0}, {0, 3}, {1, 2}};
  const double height[] = {0.0, 1.0, 1.0};
  MatrixXd coefficients(2, 600);
  for (Eigen::Index i = 0; i < coefficients.cols(); ++i) {
    coefficients.col(i) << std::sin(0.1 * double(i)),
        std::cos(0.03 * double(i));
  }
  const MatrixXd found =
      PointStress<3>(cube, kSteel, 1, points, columns).von_mises(coefficients);
  for (Eigen::Index i = 0; i < coefficients.cols(); ++i) {
    for (Eigen::Index p = 0; p < 3; ++p) {
      const double tension = 200e6 * height[p] * coefficients(1, i);
      const double shear = 100e6 * coefficients(0, i);
      EXPECT_NEAR(found(p, i), std::hypot(tension, std::sqrt(3.0) * shear),
                  1e-6 * 200e6);
    }
  }
}

}  // namespace
}  // namespace clevis::stress
