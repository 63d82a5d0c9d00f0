// Parts on elastic beds: a block by hand, a beam by Hetényi's closed form.
#include "elasticity/assembly/foundation.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "elasticity/vibration/eigenmodes.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;

part::Material material(double poissons_ratio) {
  return {"steel", 210e9, poissons_ratio, 7850.0, 355e6};
}

mesh::PartMesh<3> block(const Eigen::Vector3i& cells, const Vector3d& size) {
  return support::structured_mesh<3>({cells[0], cells[1], cells[2]}, 1,
                                     [&](const Vector3d& x) -> Vector3d {
                                       return x.cwiseProduct(size);
                                     });
}

/// @param area, centroid  of the face.
loads::LoadHistory traction_on(const std::string& group, const Vector3d& t,
                               double area, const Vector3d& centroid) {
  loads::InstantLoad load;
  load.label = "case";
  loads::SurfaceLoad surface{.group = group, .resultant = {}};
  surface.traction = t;
  surface.resultant = {.force = area * t, .moment = centroid.cross(area * t)};
  surface.total = area * t.norm();
  load.surface_loads = {surface};
  return {{}, {load}};
}

/// Displacement of the node nearest to a point.
Vector3d displacement_at(const DisplacementBasis<3>& basis, const Vector3d& p) {
  const auto positions = node_positions(basis.discretization);
  Eigen::Index at = 0;
  (positions.colwise() - p).colwise().norm().minCoeff(&at);
  return (basis.columns * basis.coefficients.col(0)).segment<3>(3 * at);
}

// Pressed by t on top, k beneath, ν = 0: −t/k at the foot, −t/k − t L/E on top,
// strain energy ½ t² A (L/E + 1/k).
TEST(Foundation, PressedBlockSinksByHand) {
  const Vector3d size(0.03, 0.02, 0.05);
  constexpr double t = 2e6, k = 5e10;
  const auto mesh = block({2, 2, 3}, size);
  const auto steel = material(0.0);
  const auto history = traction_on("z1", {0.0, 0.0, -t}, size.x() * size.y(),
                                   {0.5 * size.x(), 0.5 * size.y(), size.z()});
  for (const double tangential : {k, 0.3 * k}) {
    const auto basis = solve<3>({.mesh = mesh,
                                 .material = steel,
                                 .history = history,
                                 .fixed = {},
                                 .name = "block",
                                 .foundations = {{"z0", {k, tangential}}}},
                                2);
    const double foot = -t / k;
    const double top = foot - t * size.z() / steel.youngs_modulus;
    EXPECT_NEAR(displacement_at(basis, {0.0, 0.0, 0.0}).z(), foot,
                1e-9 * -foot);
    EXPECT_NEAR(displacement_at(basis, size).z(), top, 1e-9 * -top);
    const double area = size.x() * size.y();
    EXPECT_NEAR(basis.strain_energy[0], -0.5 * t * area * top,
                1e-9 * t * area * -top);
    EXPECT_LT(basis.checks.energy, 1e-9);
  }
}

// Pulled along its bed and twisted about its middle: forces along the face.
TEST(Foundation, RigidSlideTakesTheTangentialStiffness) {
  const Vector3d size(0.2, 0.2, 1e-3);
  constexpr double k = 1e6;  // so soft that the block moves as a rigid one
  const auto mesh = block({4, 4, 1}, size);
  const auto history =
      traction_on("z1", {300.0, 0.0, 0.0}, 0.04, {0.1, 0.1, size.z()});
  const auto basis = solve<3>({.mesh = mesh,
                               .material = material(0.3),
                               .history = history,
                               .fixed = {},
                               .name = "block",
                               .foundations = {{"z0", {1e4 * k, k}}}},
                              2);
  EXPECT_NEAR(displacement_at(basis, 0.5 * size).x(), 300.0 / k, 1e-3 * 3e-4);
}

// Half-infinite beam, force P at its end (Hetényi): w = 2 P λ/k', turn there
// 2 P λ²/k', λ⁴ = k'/4EI; left out: shear, 0.9 (λh)² = 8e-4.
TEST(Foundation, BeamOnItsBed) {
  constexpr double h = 0.01, b = 0.01, lambda = 3.0, P = 10.0;
  const auto steel = material(0.0);
  const double EI = steel.youngs_modulus * b * h * h * h / 12.0;
  const double per_length = 4.0 * EI * std::pow(lambda, 4);
  const double length = 8.0 / lambda;
  const auto mesh = block({80, 1, 1}, {length, h, b});
  const auto history = traction_on("x1", {0.0, -P / (b * h), 0.0}, b * h,
                                   {length, 0.5 * h, 0.5 * b});
  const auto basis = solve<3>(
      {.mesh = mesh,
       .material = steel,
       .history = history,
       .fixed = {{"x0", {true, false, false}}, {"z0", {false, false, true}}},
       .name = "beam",
       .foundations = {{"y0", {per_length / b, 0.0}}}},
      3);
  const double sinks = 2.0 * P * lambda / per_length;
  const double end = -displacement_at(basis, {length, 0.5 * h, 0.5 * b}).y();
  EXPECT_NEAR(end / sinks, 1.0, 1.5e-3);
  const double turn = (displacement_at(basis, {length, h, 0.5 * b}).x() -
                       displacement_at(basis, {length, 0.0, 0.5 * b}).x()) /
                      h;
  EXPECT_NEAR(turn / (2.0 * P * lambda * lambda / per_length), 1.0, 1.5e-3);
}

TEST(Foundation, BedThatLetsThePartSlideIsRefused) {
  const auto mesh = block({2, 2, 2}, {0.1, 0.1, 0.1});
  const auto history =
      traction_on("z1", {0.0, 0.0, -1e6}, 0.01, {0.05, 0.05, 0.1});
  try {
    solve<3>({.mesh = mesh,
              .material = material(0.3),
              .history = history,
              .fixed = {},
              .name = "block",
              .foundations = {{"z0", {1e10, 0.0}}}},
             2);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F001");
    EXPECT_NE(error.problem().find("translation"), std::string::npos)
        << error.problem();
  }
}

// A stiff block on soft springs: ω² = k A / m along each axis.
TEST(Foundation, BlockVibratesOnItsBed) {
  const Vector3d size(0.05, 0.05, 0.05);
  constexpr double k = 1e8;
  const auto mesh = block({1, 1, 1}, size);
  const loads::LoadHistory none;
  const auto steel = material(0.3);
  const auto modes =
      eigenmodes<3>({.mesh = mesh,
                     .material = steel,
                     .history = none,
                     .fixed = {},
                     .name = "block",
                     .foundations = {{"z0", {k, k}}, {"z1", {k, k}}}},
                    3, 3);
  const double mass = steel.density * size.prod();
  const double frequency =
      std::sqrt(2.0 * k * size.x() * size.y() / mass) / (2.0 * M_PI);
  // soft against the block: k L / E = 2e-5
  EXPECT_NEAR(modes.frequencies[0] / frequency, 1.0, 1e-4);
  EXPECT_NEAR(modes.frequencies[2] / frequency, 1.0, 1e-4);
}

}  // namespace
}  // namespace clevis::elasticity
