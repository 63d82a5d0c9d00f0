// Mass matrix and free vibrations against closed forms. Source: docs/theory.md,
// "Vibration and impact".

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "elasticity/assembly/supports.h"
#include "elasticity/vibration/eigenmodes.h"
#include "elasticity/vibration/vibrating_part.h"
#include "loads/holds/spread_seats.h"
#include "support/convergence.h"
#include "support/structured_mesh.h"
#include "support/weld.h"

namespace clevis {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};
const loads::LoadHistory kNoLoads;

double shear_speed(const part::Material& material) {
  return std::sqrt(material.youngs_modulus /
                   (2.0 * (1.0 + material.poissons_ratio) * material.density));
}

mesh::PartMesh<3> block_mesh(std::array<int, 3> cells, const Vector3d& size) {
  return support::structured_mesh<3>(cells, 1,
                                     [size](const Vector3d& x) -> Vector3d {
                                       return x.cwiseProduct(size);
                                     });
}

/// Relative distance of the nearest frequency [1].
double nearest(const Eigen::VectorXd& frequencies, double exact) {
  return ((frequencies.array() - exact).abs().minCoeff()) / exact;
}

TEST(Mass, TotalAndInertiaOfABlock) {
  const Vector3d size(0.03, 0.05, 0.02);
  const auto mesh = block_mesh({2, 3, 1}, size);
  for (int degree = 1; degree <= 4; ++degree) {
    const auto part = elasticity::vibrating_part<3>(
        {mesh, kSteel, kNoLoads, {}, "block"}, degree);
    const double mass = kSteel.density * size.prod();
    EXPECT_NEAR(part.mass / mass, 1.0, 1e-13);
    const auto modes = elasticity::rigid_modes<3>(
        elasticity::node_positions(part.discretization), 0.5 * size, 1.0);
    const MatrixXd inertia = modes.transpose() * part.system.mass(modes);
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(inertia(d, d) / mass, 1.0, 1e-12);
      const double square = size.squaredNorm() - size[d] * size[d];
      // Degree 1 interpolates p, not p²: the product of two is integrated.
      EXPECT_NEAR(inertia(3 + d, 3 + d) / (mass * square / 12.0), 1.0, 1e-12);
    }
    EXPECT_LT((inertia - MatrixXd(inertia.diagonal().asDiagonal()))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12 * mass);
    EXPECT_LT(part.system.stiffness(modes).cwiseAbs().maxCoeff(),
              1e-10 * kSteel.youngs_modulus * size[0]);
  }
}

/// Free a × a × t block: f = c_s / (√2 a), whatever t and ν.
TEST(Modes, LameModeOfAFreeBlock) {
  const double a = 0.1;
  const auto mesh = block_mesh({3, 3, 1}, {a, a, 0.04});
  const auto modes =
      elasticity::eigenmodes<3>({mesh, kSteel, kNoLoads, {}, "block"}, 4, 26);
  const double exact = shear_speed(kSteel) / (std::sqrt(2.0) * a);
  EXPECT_EQ(modes.rigid, 6);
  EXPECT_EQ(modes.frequencies[5], 0.0);
  EXPECT_GT(modes.frequencies[6], 0.1 * exact);
  EXPECT_LT(nearest(modes.frequencies, exact), 1e-6);
  EXPECT_LT(modes.residual.maxCoeff(), 1e-7);
  // All mass moves with the rigid motions, none with the others.
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(modes.participation.col(d).head(6).sum(), 1.0, 1e-10);
    EXPECT_LT(modes.participation.col(d).tail(20).sum(), 1e-10);
  }
}

/// Plane stress has the same mode: nothing strains along z.
TEST(Modes, LameModeOfAFreePlate) {
  const double a = 0.1;
  auto mesh = support::structured_mesh<2>({3, 3}, 1,
                                          [a](const Vector2d& x) -> Vector2d {
                                            return a * x;
                                          });
  mesh.thickness = 0.01;
  const auto modes =
      elasticity::eigenmodes<2>({mesh, kSteel, kNoLoads, {}, "plate"}, 4, 12);
  EXPECT_EQ(modes.rigid, 3);
  EXPECT_LT(
      nearest(modes.frequencies, shear_speed(kSteel) / (std::sqrt(2.0) * a)),
      1e-6);
}

/// Torsion of a free round bar: f_n = n c_s / (2 L).
TEST(Modes, TorsionOfAFreeRoundBar) {
  const double length = 0.1;
  const auto mesh = support::round_bar(0.02, length, 1, 3, 4);
  const auto modes =
      elasticity::eigenmodes<3>({mesh, kSteel, kNoLoads, {}, "bar"}, 4, 16);
  EXPECT_EQ(modes.rigid, 6);
  EXPECT_LT(nearest(modes.frequencies, shear_speed(kSteel) / (2.0 * length)),
            1e-6);
  // Bending about either axis: the same frequency twice.
  EXPECT_NEAR(modes.frequencies[6] / modes.frequencies[7], 1.0, 1e-8);
  EXPECT_GT(modes.frequencies[8] / modes.frequencies[7], 1.01);
}

/// 1 : 100, ν = 0: shear and rotary inertia take 7e-5 of Euler's frequency.
TEST(Modes, CantileverOfASlenderRod) {
  const part::Material material{"no Poisson", 210e9, 0.0, 7850.0, 355e6};
  const double length = 1.0, side = 0.01;
  const auto mesh = block_mesh({20, 1, 1}, {length, side, side});
  const auto modes = elasticity::eigenmodes<3>(
      {mesh, material, kNoLoads, {{"x0", {true, true, true}}}, "rod"}, 3, 4);
  const double euler =
      1.875104069 * 1.875104069 / (2.0 * std::numbers::pi) *
      std::sqrt(material.youngs_modulus * side * side /
                (12.0 * material.density * length * length * length * length));
  EXPECT_EQ(modes.rigid, 0);
  for (int k = 0; k < 2; ++k) {  // about y and about z
    EXPECT_LT(modes.frequencies[k], euler);
    EXPECT_NEAR(modes.frequencies[k] / euler, 1.0, 2e-4);
  }
  EXPECT_NEAR(modes.frequencies[2] / euler,
              std::pow(4.694091133 / 1.875104069, 2), 0.02);
  // Its residual is 1e-3, the period has that squared.
  EXPECT_NEAR(
      elasticity::FirstPeriods<3>(
          {mesh, material, kNoLoads, {{"x0", {true, true, true}}}, "rod"}, 3)
              .at(0.0) *
          modes.frequencies[0],
      1.0, 1e-6);
}

/// By the end's way and turn, its own mass consistent: (K − ω² M ± ω h) u = 0
/// on y + i z, between `low` and `high` [1/s].
double frequency_of_rod(double length, double side, double mass, double turn,
                        double momentum, double low, double high) {
  const double k =
      kSteel.youngs_modulus * std::pow(side, 4) / 12.0 / std::pow(length, 3);
  const double m = kSteel.density * side * side * length / 420.0;
  const auto determinant = [&](double w) {
    const double a = 12.0 * k - w * w * (156.0 * m + mass);
    const double b = -6.0 * length * k + w * w * 22.0 * length * m;
    const double c = 4.0 * length * length * k -
                     w * w * (4.0 * length * length * m + turn) + w * momentum;
    return a * c - b * b;
  };
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (determinant(low) * determinant(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

/// A bar in a guide that travels, at places between those of its shapes: by the
/// cubic to a per cent, where lines have three.
TEST(SeatShapes, BarInAGuideThatTravels) {
  const double length = 0.4, height = 0.005, guide = 0.06;
  const int last = 80;
  const auto mesh = block_mesh({40, 1, 2}, {length, height, 0.02});
  loads::LoadHistory history;
  loads::Seat& seat = history.seats.emplace_back();
  seat = {.name = "guide", .group = "y0", .kind = loads::SeatKind::kTraction};
  seat.p_LS = {0.5 * length, 0.5 * height, 0.01};
  seat.slide =
      loads::SlideWall{.normal_L = Eigen::Vector3d::UnitY(), .opposite = "y1"};
  seat.slide->across_L = Eigen::Vector3d::UnitZ();
  loads::SeatHold hold;
  hold.held = Eigen::MatrixXd::Identity(6, 6).rightCols(5);
  hold.weighed = Eigen::MatrixXd::Zero(6, 0);
  for (int i = 0; i <= last; ++i) {
    loads::InstantLoad& instant = history.instants.emplace_back();
    instant.time = i;
    instant.wrenches.resize(1);
    loads::ContactZone& zone = instant.zones.emplace_back();
    const double middle = 0.15 - 0.3 * i / last;
    zone.low[0] = middle - 0.5 * guide;
    zone.high[0] = middle + 0.5 * guide;
  }
  history.hold = [&](double time) {
    loads::SeatHold there = hold;
    there.zones = history.instants[static_cast<std::size_t>(time)].zones;
    return there;
  };
  const loads::SpreadSeats seats(history, 8, 1e-3);
  ASSERT_TRUE(seats.travels());
  std::vector<loads::SeatHold> holds;
  for (int i = 0; i <= last; i += 2) {
    holds.push_back(seats.spread(history.hold(i), static_cast<std::size_t>(i)));
  }
  elasticity::FirstPeriods<3> periods({mesh, kSteel, history, {}, "bar"}, 2);
  const auto shapes = periods.seat_shapes(elasticity::span_of(holds, {}),
                                          seats.seats(), seats.zones());
  ASSERT_TRUE(shapes);
  for (const std::size_t i : {0U, 5U, 14U, 33U, 45U, 75U, 80U}) {
    const auto there = static_cast<double>(i);
    const double first = std::sqrt(
        shapes->held_by(seats.spread(history.hold(there), i)).squares[0]);
    EXPECT_NEAR(first * periods.at(there) / (2.0 * std::numbers::pi), 1.0,
                0.012)
        << i;
  }
}

/// Loads of a square rod along x from the origin, with a seat at either end.
/// @param hold  outlives them.
loads::LoadHistory ends_of_rod(double length, double side,
                               const loads::SeatHold& hold) {
  loads::LoadHistory history;
  history.seats = {
      {.name = "foot", .group = "x0", .kind = loads::SeatKind::kTraction},
      {.name = "end", .group = "x1", .kind = loads::SeatKind::kTraction}};
  history.seats[0].p_LS = {0.0, 0.5 * side, 0.5 * side};
  history.seats[1].p_LS = {length, 0.5 * side, 0.5 * side};
  history.hold = [&hold](double) {
    return hold;
  };
  return history;
}

/// A rod that is held at one end carries a rotor on the other.
TEST(SeatShapes, RotorOnTheEndOfARod) {
  const double length = 0.5, side = 0.01, mass = 1.0, turn = 0.05;
  const auto mesh = block_mesh({10, 1, 1}, {length, side, side});
  loads::SeatHold hold;
  hold.held = Eigen::MatrixXd::Identity(12, 6);
  hold.weighed = Eigen::MatrixXd::Zero(12, 6);
  hold.weighed.block<3, 3>(6, 0).diagonal().setConstant(std::sqrt(mass));
  hold.weighed.block<2, 2>(10, 4).diagonal().setConstant(std::sqrt(turn));
  const auto history = ends_of_rod(length, side, hold);
  elasticity::FirstPeriods<3> periods({mesh, kSteel, history, {}, "rod"}, 3);
  const double still = frequency_of_rod(length, side, mass, turn, 0, 10, 80);
  const double h = 2.0 * turn * still;
  hold.spin = Eigen::MatrixXd::Zero(12, 12);
  hold.spin(10, 11) = h;  // θ' × h along x
  hold.spin(11, 10) = -h;
  const auto shapes =
      periods.seat_shapes(elasticity::span_of({hold}, {}), history.seats, {});
  ASSERT_TRUE(shapes);
  const double first = std::sqrt(shapes->held_by(hold).squares[0]);
  EXPECT_NEAR(first * periods.at(0.0) / (2.0 * std::numbers::pi), 1.0, 1e-4);
  const auto moved = shapes->moved_by_spin(hold);
  const double down = frequency_of_rod(length, side, mass, turn, -h, 10, still);
  const double up = frequency_of_rod(length, side, mass, turn, h, still, 80);
  EXPECT_LT(down, 0.8 * still);
  EXPECT_GT(up, 1.2 * still);
  EXPECT_NEAR(moved[0].still / still, 1.0, 5e-3);
  EXPECT_NEAR(moved[1].still / still, 1.0, 5e-3);
  EXPECT_NEAR(moved[0].moved / down, 1.0, 5e-3);
  EXPECT_NEAR(moved[1].moved / up, 1.0, 5e-3);
}

/// A rod that carries a mass stands on a spring along it: its share of the
/// swing is that of a rod under the forces of even acceleration.
TEST(SeatShapes, ARodOnASpringHasAShareOfItsSwing) {
  const double length = 0.5, side = 0.01, mass = 1.0;
  const auto mesh = block_mesh({10, 1, 1}, {length, side, side});
  const double axial = kSteel.youngs_modulus * side * side / length;
  const double spring = 0.01 * axial;
  loads::SeatHold clamped;
  clamped.held = Eigen::MatrixXd::Identity(12, 6);
  clamped.weighed = Eigen::MatrixXd::Zero(12, 3);
  clamped.weighed.block<3, 3>(6, 0).diagonal().setConstant(std::sqrt(mass));
  loads::SeatHold sprung = clamped;
  sprung.held = clamped.held.rightCols(5).eval();
  sprung.sprung = std::sqrt(spring) * clamped.held.leftCols(1);
  const auto history = ends_of_rod(length, side, clamped);
  elasticity::FirstPeriods<3> periods({mesh, kSteel, history, {}, "rod"}, 2);
  const auto shapes = periods.seat_shapes(
      elasticity::span_of({clamped, sprung}, {}), history.seats, {});
  ASSERT_TRUE(shapes);
  EXPECT_NEAR(shapes->held_by(clamped).own_share.minCoeff(), 1.0, 1e-9);
  const double own = kSteel.density * side * side * length;
  const double of_rod = (mass * mass + mass * own + own * own / 3.0) / axial;
  const double of_spring = (mass + own) * (mass + own) / spring;
  const double share = of_rod / (of_rod + of_spring);
  EXPECT_NEAR(shapes->held_by(sprung).own_share.minCoeff() / share, 1.0, 0.02);
}

/// The frequency's error falls with the power 2p of the cell's size.
TEST(Modes, ErrorFallsWithTwiceTheDegree) {
  const double a = 0.1;
  const double exact = shear_speed(kSteel) / (std::sqrt(2.0) * a);
  for (const int degree : {1, 2}) {
    std::vector<double> errors;
    for (const int cells : {4, 8, 16}) {
      auto mesh = support::structured_mesh<2>(
          {cells, cells}, 1, [a](const Vector2d& x) -> Vector2d {
            return a * x;
          });
      mesh.thickness = 0.01;
      errors.push_back(
          nearest(elasticity::eigenmodes<2>(
                      {mesh, kSteel, kNoLoads, {}, "plate"}, degree, 10)
                      .frequencies,
                  exact));
    }
    EXPECT_NEAR(support::last_rate(errors), 2.0 * degree, 0.1);
  }
}

}  // namespace
}  // namespace clevis
