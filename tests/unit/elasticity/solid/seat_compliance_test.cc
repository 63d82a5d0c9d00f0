// Compliance of a free bar at its ends against closed forms.
#include "elasticity/solid/seat_compliance.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
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

loads::Seat seat(const std::string& group, const Vector3d& p_LS) {
  loads::Seat result;
  result.name = result.group = group;
  result.p_LS = p_LS;
  return result;
}

SeatCompliance bar(double turned = 0.0, std::vector<loads::Seat> more = {},
                   const std::vector<loads::Seat>& loaded = {}) {
  const Eigen::AngleAxisd R(turned, Vector3d::UnitZ());
  const auto mesh = support::structured_mesh<3>(
      {10, 1, 1}, 1, [&](const Vector3d& x) -> Vector3d {
        return R * Vector3d(kLength * x[0], kWidth * (x[1] - 0.5),
                            kHeight * (x[2] - 0.5));
      });
  more.insert(more.begin(), {seat("x0", Vector3d::Zero()),
                             seat("x1", R * Vector3d(kLength, 0.0, 0.0))});
  return seat_compliance(mesh, kMaterial,
                         mesh::mass_properties(mesh, kMaterial.density), more,
                         loaded, "bar");
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
  const Eigen::MatrixXd C = bar().by_wrench;
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

// Spin across its length draws a bar's ends apart by ρ ω² L³/12E, of which its
// component across counts: of a bar along the diagonal of x and y
// (ω_x² + ω_y²)/2 − ω_x ω_y + ω_z².
TEST(SeatCompliance, SpinDrawsTheEndsApart) {
  const double apart = kMaterial.density * std::pow(kLength, 3) / 12.0 /
                       kMaterial.youngs_modulus;
  const std::array<std::array<double, 6>, 2> wanted{
      {{0.0, 1.0, 1.0, 0.0, 0.0, 0.0}, {0.5, 0.5, 1.0, -1.0, 0.0, 0.0}}};
  for (const std::size_t turned : {0u, 1u}) {
    const double angle = turned * std::numbers::pi / 4.0;
    const Vector3d along(std::cos(angle), std::sin(angle), 0.0);
    const Eigen::MatrixXd D = bar(angle).by_spin;
    for (Eigen::Index k = 0; k < 6; ++k) {
      const double found =
          along.dot(D.block<3, 1>(6, k) - D.block<3, 1>(0, k)) / apart;
      EXPECT_NEAR(found, wanted[turned][static_cast<std::size_t>(k)], 1e-3)
          << k;
    }
  }
}

// A load moves the seats as a wrench on a further seat does (Betti): of the two
// ends, the sides across y and z.
TEST(SeatCompliance, LoadsElsewhereAreSeatsThatDoNotCount) {
  const std::vector<loads::Seat> sides{
      seat("y1", {0.3 * kLength, kWidth, 0.01}),
      seat("z0", {0.0, 0.0, -kHeight})};
  const Eigen::MatrixXd C = bar(0.0, sides).by_wrench;
  const SeatCompliance found = bar(0.0, {}, sides);
  ASSERT_EQ(found.by_load.rows(), 12);
  ASSERT_EQ(found.by_load.cols(), 12);
  EXPECT_LT((found.by_load - C.block(0, 12, 12, 12)).norm(), 1e-9 * C.norm());
  EXPECT_LT((found.by_wrench - C.block(0, 0, 12, 12)).norm(), 1e-9 * C.norm());
  EXPECT_GT(found.by_load.norm(), 1e-3 * C.norm());
}

}  // namespace
}  // namespace clevis::elasticity
