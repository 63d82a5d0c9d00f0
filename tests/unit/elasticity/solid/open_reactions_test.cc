// A bar held at both ends and whirled about one of them: ends stay flat, ν = 0,
// so the rod's closed form is exact.
#include "elasticity/solid/open_reactions.h"

#include <gtest/gtest.h>

#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;

TEST(OpenReactions, WhirledBarBetweenTwoEnds) {
  const part::Material material{"steel", 210e9, 0.0, 7850.0, 355e6};
  constexpr double kLength = 0.2, kWidth = 0.02, kHeight = 0.01;
  constexpr double kOmega = 300.0;
  const double area = kWidth * kHeight;
  const auto mesh = support::structured_mesh<3>(
      {10, 1, 1}, 1, [&](const Vector3d& x) -> Vector3d {
        return {kLength * x[0], kWidth * (x[1] - 0.5), kHeight * (x[2] - 0.5)};
      });
  loads::LoadHistory history;
  history.seats.resize(2);
  history.seats[0].name = history.seats[0].group = "x0";
  history.seats[1].name = history.seats[1].group = "x1";
  history.seats[1].p_LS.x() = kLength;
  loads::InstantLoad load;
  load.rigid.omega.z() = kOmega;
  load.wrenches.resize(2);
  // All at x0: ∫ ρ A ω² x dx.
  const double all =
      material.density * area * kOmega * kOmega * kLength * kLength / 2.0;
  load.wrenches[0].force.x() = -all;
  history.instants.push_back(load);
  const double unit = all;
  std::vector<loads::Wrench> pull(2);
  pull[0].force.x() = unit;
  pull[1].force.x() = -unit;
  const auto energy = pattern_energy(mesh, material, history, {pull}, "bar");
  // N(x) = 1 of the pattern: A = L/EA
  EXPECT_NEAR(
      energy.A(0, 0) * material.youngs_modulus * area / (unit * unit * kLength),
      1.0, 1e-6);
  // u(L) = 0: a third is left at x0, two thirds at x1
  const double z = -energy.b[0] / energy.A(0, 0);
  EXPECT_NEAR((-all + z * unit) / all, -1.0 / 3.0, 1e-5);
}

}  // namespace
}  // namespace clevis::elasticity
