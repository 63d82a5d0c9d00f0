// A body with a domed end that is pressed evenly all round, on the dome by a
// force: whatever its shape, σ = −p 1.

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "elasticity/revolution/revolution_solve.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "support/structured_mesh.h"

namespace clevis {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};
constexpr double kPressure = 80e6;

/// @param at  the resultant's line.
void press(loads::InstantLoad& load, const std::string& group,
           const Vector3d& force, const Vector3d& at) {
  load.surface_loads.push_back({.group = group,
                                .pressure = kPressure,
                                .resultant = {force, at.cross(force)},
                                .total = force.norm()});
}

loads::LoadHistory dome_pressed_by(const Vector3d& force, const Vector3d& at) {
  loads::LoadHistory history;
  history.seats.push_back({.name = "x1",
                           .group = "x1",
                           .kind = loads::SeatKind::kPressure,
                           .p_LS = at});
  history.instants.resize(1);
  history.instants[0].wrenches.push_back({.force = force});
  return history;
}

double largest_deviation(const stress::InstantField& field) {
  const Eigen::Matrix<double, 1, 6> exact =
      -kPressure * Eigen::Matrix<double, 1, 6>(1.0, 1.0, 1.0, 0.0, 0.0, 0.0);
  double largest = 0.0;
  for (const auto& cell : field.stress) {
    largest = std::max(
        largest, (cell.rowwise() - exact).cwiseAbs().maxCoeff() / kPressure);
  }
  return largest;
}

TEST(Dome, OfABlockTakesAForceAsPressure) {
  const Vector3d size(0.03, 0.02, 0.01);
  constexpr double kRise = 0.4;  // of the length
  const auto mesh = support::structured_mesh<3>(
      {2, 1, 1}, 2, [&](const Vector3d& x) -> Vector3d {
        const double dome = 16.0 * x[1] * (1.0 - x[1]) * x[2] * (1.0 - x[2]);
        return size.cwiseProduct(
            Vector3d(x[0] * (1.0 + kRise * dome), x[1], x[2]));
      });
  const Vector3d middle = 0.5 * size;
  auto history = dome_pressed_by(
      -kPressure * size[1] * size[2] * Vector3d::UnitX(), middle);
  auto& load = history.instants[0];
  press(load, "x0", kPressure * size[1] * size[2] * Vector3d::UnitX(), middle);
  // The dome is level with the block's edges, so that sides stay rectangles.
  for (const int axis : {1, 2}) {
    const Vector3d force =
        kPressure * size.prod() / size[axis] * Vector3d::Unit(axis);
    press(load, axis == 1 ? "y0" : "z0", force, middle);
    press(load, axis == 1 ? "y1" : "z1", -force, middle);
  }
  const auto basis =
      elasticity::solve<3>({mesh, kSteel, history, {}, "block"}, 3);
  EXPECT_LT(largest_deviation(stress::instant_field<3>(basis, kSteel, 3, 0)),
            1e-9);
}

TEST(Dome, OfATurnedBarTakesAForceAsPressure) {
  constexpr double kRadius = 0.01, kLength = 0.03, kRise = 0.3;
  mesh::Revolution solid;
  solid.meridian =
      support::structured_mesh<2>({3, 2}, 2, [](const Vector2d& x) {
        return Vector2d(kLength * x[0] * (1.0 + kRise * (1.0 - x[1] * x[1])),
                        kRadius * x[1]);
      });
  solid.meridian.thickness = 1.0;
  solid.origin = Vector3d::Zero();
  solid.axes.setIdentity();
  const Vector3d force = kPressure * pi * kRadius * kRadius * Vector3d::UnitX();
  auto history = dome_pressed_by(-force, {kLength, 0.0, 0.0});
  press(history.instants[0], "x0", force, Vector3d::Zero());
  press(history.instants[0], "y1", Vector3d::Zero(), Vector3d::Zero());
  const auto solution =
      elasticity::solve_revolution({solid, kSteel, history, {}, "bar"}, 3);
  EXPECT_LT(
      largest_deviation(stress::instant_field<3>(solution.basis, kSteel, 3, 0)),
      1e-5);  // slopes beside the axis
}

}  // namespace
}  // namespace clevis
