#include "stress/displacement/finite_motion.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "elasticity/solid/solid_solve.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

const part::Material kCork{"cork", 70e9, 0.0, 2700.0, 200e6};
const Vector3d kSize(0.2, 0.01, 0.02);
constexpr int kCells = 10;

loads::LoadHistory pulled_at_the_end(const Vector3d& traction) {
  loads::LoadHistory history;
  for (const double share : {0.5, -1.0}) {
    loads::SurfaceLoad load;
    load.group = "x1";
    load.traction = share * traction;
    load.resultant.force = kSize.y() * kSize.z() * load.traction;
    load.resultant.moment =
        Vector3d(kSize.x(), 0.5 * kSize.y(), 0.5 * kSize.z())
            .cross(load.resultant.force);
    load.total = load.resultant.force.norm();
    auto& instant = history.instants.emplace_back();
    instant.surface_loads.push_back(load);
  }
  return history;
}

FieldMotion motion_of(const Vector3d& traction) {
  const auto mesh = support::structured_mesh<3>(
      {kCells, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return kSize.cwiseProduct(x);
      });
  const auto history = pulled_at_the_end(traction);
  const elasticity::ElasticProblem<3> problem{
      mesh, kCork, history, {{"x0", {true, true, true}}}, "bar"};
  return field_motion<3>(elasticity::solve<3>(problem, 3));
}

// θ(x) = F (L x − x²/2) / (E I), ν = 0; half a cell from the end.
TEST(FiniteMotion, CantileverTurnsAsBeamTheorySays) {
  const double traction = 4e6;
  const double force = traction * kSize.y() * kSize.z();
  const double inertia = kSize.z() * std::pow(kSize.y(), 3) / 12.0;
  const double x = kSize.x() * (1.0 - 0.5 / kCells);
  const double slope =
      force * (kSize.x() * x - 0.5 * x * x) / (kCork.youngs_modulus * inertia);
  const auto motion = motion_of({0.0, traction, 0.0});
  EXPECT_NEAR(motion.rotation / slope, 1.0, 0.01);  // and its shear
  EXPECT_EQ(motion.rotation_instant, 1);
}

TEST(FiniteMotion, BarInTensionStrainsAndDoesNotTurn) {
  const auto motion = motion_of({70e6, 0.0, 0.0});
  EXPECT_NEAR(motion.strain, 1e-3, 1e-9);
  EXPECT_EQ(motion.strain_instant, 1);
  EXPECT_LT(motion.rotation, 1e-9);
}

}  // namespace
}  // namespace clevis::stress
