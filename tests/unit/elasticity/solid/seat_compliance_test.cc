// Compliance of a free bar at its ends against closed forms.
#include "elasticity/solid/seat_compliance.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/quality/mass_properties.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// ν = 0: ends that stay flat under a linear traction are the exact solution.
const part::Material kMaterial{"steel", 210e9, 0.0, 7850.0, 355e6};
constexpr double kLength = 0.2, kWidth = 0.02, kHeight = 0.01;

Eigen::MatrixXd bar() {
  const auto mesh = support::structured_mesh<3>(
      {10, 1, 1}, 1, [&](const Vector3d& x) -> Vector3d {
        return {kLength * x[0], kWidth * (x[1] - 0.5), kHeight * (x[2] - 0.5)};
      });
  std::vector<loads::Seat> seats(2);
  seats[0].name = seats[0].group = "x0";
  seats[1].name = seats[1].group = "x1";
  seats[1].p_LS.x() = kLength;
  return seat_compliance(mesh, kMaterial,
                         mesh::mass_properties(mesh, kMaterial.density), seats,
                         "bar");
}

/// 2 U under a wrench at one end and what balances it at the other.
double twice_energy(const Eigen::MatrixXd& C, int component,
                    const VectorXd& at_x1) {
  VectorXd w = VectorXd::Zero(12);
  w[component] = -1.0;
  w.tail(6) = at_x1;
  return w.dot(C * w);
}

TEST(SeatCompliance, BarInTensionBendingAndShear) {
  const Eigen::MatrixXd C = bar();
  const double E = kMaterial.youngs_modulus, area = kWidth * kHeight;
  EXPECT_LT((C - C.transpose()).norm(), 1e-15 * C.norm());
  EXPECT_NEAR(twice_energy(C, 0, VectorXd::Unit(6, 0)) * E * area / kLength,
              1.0, 1e-6);
  const std::array<double, 2> inertia{kWidth * std::pow(kHeight, 3) / 12.0,
                                      kHeight * std::pow(kWidth, 3) / 12.0};
  for (const int axis : {1, 2}) {  // a couple: L / EI
    const double I = inertia[static_cast<std::size_t>(axis - 1)];
    EXPECT_NEAR(twice_energy(C, 3 + axis, VectorXd::Unit(6, 3 + axis)) * E * I /
                    kLength,
                1.0, 1e-6);
  }
  // Two opposite forces along y balanced by a couple about z at x1, as a
  // cantilever: L³/3EI and 6/5 L/GA of shear.
  VectorXd balance = VectorXd::Unit(6, 1);
  balance[5] = -kLength;
  const double G = E / 2.0;
  const double cantilever = std::pow(kLength, 3) / (3.0 * E * inertia[1]) +
                            1.2 * kLength / (G * area);
  EXPECT_NEAR(twice_energy(C, 1, balance) / cantilever, 1.0, 2e-3);
}

}  // namespace
}  // namespace clevis::elasticity
